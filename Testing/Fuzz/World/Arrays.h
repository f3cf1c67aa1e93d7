// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Arrays_h
#define Fuzz_Arrays_h

#include "World/World.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>

class vtkDataSetAttributes;

namespace Fuzz
{

/// Arrays of samples and ghost arrays, of all types and lengths, right ones and wrong ones.
namespace Arrays
{

/// Samples for so many places on a lattice, by some formula, of some type.
/// \param dimensions samples along each axis
vtkSmartPointer<vtkDataArray> Make(World& world, const int dimensions[3]);

/// Other samples in the same array; all of them or some.
void Rewrite(World& world, vtkDataArray* array, const int dimensions[3], bool all);

/// A ghost array: of some bits, sometimes of a wrong length or type.
void AddGhosts(World& world, vtkDataSetAttributes* attributes, vtkIdType count);

/// Tell the world where isovalues are worth asking for.
void Survey(World& world, vtkDataArray* array);

}

}

#endif
