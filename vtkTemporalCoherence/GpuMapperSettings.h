// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GpuMapperSettings_h
#define TemporalCoherence_GpuMapperSettings_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkGPUVolumeRayCastMapper;
class vtkRenderer;
class vtkTemporalCoherenceVolumeMapper;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The reason why vtkTemporalCoherenceVolumeMapper cannot draw the volume of a GPU mapper, as the
/// end of a sentence; empty if it can. BlendVolumes is not considered.
std::string WhyNotDrawn(
  vtkGPUVolumeRayCastMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

/// Copy the input and all relevant settings of a mapper to another. Equal settings are not
/// modified.
void HandOver(vtkGPUVolumeRayCastMapper* from, vtkTemporalCoherenceVolumeMapper* to);

}

#endif
