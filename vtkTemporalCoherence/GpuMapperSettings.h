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

/// Why vtkTemporalCoherenceVolumeMapper cannot draw what a GPU mapper has to draw, as the end of a
/// sentence; empty if it can. Who blends volumes is not asked.
std::string WhyNotDrawn(
  vtkGPUVolumeRayCastMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

/// True if VTK's mapper may take a tenth of the time where OpenGL runs on the CPU: all samples
/// along a ray are blended, and none is interpolated.
bool IsSlowlyBlended(int blendMode, vtkVolume* volume);

/// Copy the input and all relevant settings of a mapper to another. Equal settings are not
/// modified.
void HandOver(vtkGPUVolumeRayCastMapper* from, vtkTemporalCoherenceVolumeMapper* to);

}

#endif
