// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumeOfArray_h
#define TemporalCoherence_VolumeOfArray_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

class OutOfCoreVolume;

/// Let an array tell the volume that its samples are read from.
void SetVolume(vtkDataArray* array, const std::shared_ptr<const OutOfCoreVolume>& volume);

/// The volume that the samples of an array are read from (MakeArray); null for other arrays.
/// \param array may be null
std::shared_ptr<const OutOfCoreVolume> VolumeOf(vtkDataArray* array);

/// True if the samples of an array are read in bricks.
bool AreInBricks(vtkDataArray* array);

}

#endif
