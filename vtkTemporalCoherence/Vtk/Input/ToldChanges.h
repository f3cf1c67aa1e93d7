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

// Who writes into the samples of an image may tell where. The array keeps that in its information,
// so that all mappers of the image know.

/// Call Modified() of an array of an image, and keep that only values within an extent changed.
/// \param array  of points or cells; null: the active scalars
/// \param extent of points or cells; clamped to the image's
/// \return false if the image has no such array
bool TellChange(vtkImageData* image, vtkDataArray* array, const std::array<int, 6>& extent);

/// The last changes that were told, oldest first. Stamps are those of fields of the image.
std::vector<SampleChange> ToldChanges(vtkDataArray* array);

}

#endif
