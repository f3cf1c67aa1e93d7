// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RegionFromMapper_h
#define TemporalCoherence_RegionFromMapper_h

#include "Input/FieldFromImage.h"
#include "Scene/Region.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolumeMapper;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Make the region of a field that a mapper's clipping planes and cropping keep. Clipping planes
/// lie in the world, cropping planes along the axes of the image, in coordinates of its origin and
/// spacing.
/// \param error receives the mistake and its remedy
/// \return false on error
bool MakeRegion(vtkVolumeMapper* mapper, const ImageAxes& axes, Region& region, std::string& error);

}

#endif
