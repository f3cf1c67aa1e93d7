// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Arrays_h
#define Fuzz_Arrays_h

#include "World/World.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>

#include <array>
#include <vector>

class vtkDataSet;
class vtkDataSetAttributes;

namespace Fuzz
{

/// Arrays of samples and ghost arrays, of all types and lengths, right ones and wrong ones.
namespace Arrays
{

/// Where samples lie, in a box from -1 to 1.
using Places = std::vector<std::array<double, 3>>;

/// Places on a lattice.
/// \param dimensions samples along each axis
Places PlacesOf(const int dimensions[3]);

/// The points or the centres of the cells of any data.
Places PlacesOf(vtkDataSet* data, bool onCells);

/// Samples by some formula, of some type.
vtkSmartPointer<vtkDataArray> Make(World& world, const Places& places);

/// Other samples in the same array; all of them or some.
void Rewrite(World& world, vtkDataArray* array, const Places& places, bool all);

/// A ghost array: of some bits, sometimes of a wrong length or type.
void AddGhosts(World& world, vtkDataSetAttributes* attributes, vtkIdType count);

/// Tell the world where isovalues are worth asking for.
void Survey(World& world, vtkDataArray* array);

}

}

#endif
