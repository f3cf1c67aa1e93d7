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

/// Why what a GPU mapper is to draw is nothing for vtkTemporalCoherenceVolumeMapper, as the end of
/// a sentence; empty if it may be.
std::string WhyNotIsosurfaces(
  vtkGPUVolumeRayCastMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

/// Give a mapper the input and all settings of another that have an effect on it. Nothing is
/// modified that is the same already.
void HandOver(vtkGPUVolumeRayCastMapper* from, vtkTemporalCoherenceVolumeMapper* to);

}

#endif
