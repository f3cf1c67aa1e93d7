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

/// What a mapper's clipping planes, which lie in the world, and its cropping leave of a field.
/// Cropping planes are meant as vtkVolumeMapper says, along the axes of the image with its origin
/// and spacing in mind.
/// \param error gets what is wrong and what to do about it
/// \return false on error
bool MakeRegion(vtkVolumeMapper* mapper, const ImageAxes& axes, Region& region, std::string& error);

}

#endif
