// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ToldChanges_h
#define TemporalCoherence_ToldChanges_h

#include "Scene/SampleChanges.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

// A program that writes into the samples of an image may tell where it wrote. The array keeps these
// extents in its information, where all mappers of the image find them. Files do not hold them.

/// Call Modified() of an array of an image, and keep that only values within an extent changed.
/// \param array  of points or cells; null: the active scalars
/// \param extent of points or cells; what lies beyond the image's does not count
/// \return false if the image has no such array
bool TellChange(vtkImageData* image, vtkDataArray* array, const std::array<int, 6>& extent);

/// The last changes that were told of an array in an image of these dimensions, oldest first.
/// Stamps are those of fields of the image.
std::vector<SampleChange> ToldChanges(vtkDataArray* array, const glm::ivec3& dimensions);

}

#endif
