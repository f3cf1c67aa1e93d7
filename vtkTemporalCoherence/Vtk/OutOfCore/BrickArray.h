// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BrickArray_h
#define TemporalCoherence_BrickArray_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkSmartPointer.h>

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

class OutOfCoreVolume;

/// An array of VTK for the samples of a volume that are read when they are needed. Its values
/// cannot be changed. Of a mapped volume it is an ordinary array, in place. Any other gives
/// values one by one, slowly. A filter that asks for its address gets that of a copy of all
/// samples.
vtkSmartPointer<vtkDataArray> MakeArray(const std::shared_ptr<const OutOfCoreVolume>& volume);

/// A copy of the small field that stands in for a volume (OutOfCoreVolume::Coarse), where it lies;
/// null if there is none.
/// \throws std::bad_alloc
vtkSmartPointer<vtkImageData> MakeCoarseImage(const OutOfCoreVolume& volume);

}

#endif
