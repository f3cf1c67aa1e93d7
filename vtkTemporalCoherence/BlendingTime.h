// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BlendingTime_h
#define TemporalCoherence_BlendingTime_h

#include "vtkTemporalCoherenceCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkGPUVolumeRayCastMapper;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Estimate the CPU time that vtkTemporalCoherenceVolumeMapper takes to blend the volume of a GPU
/// mapper, as a multiple of the time of VTK's mapper where OpenGL itself runs on the CPU.
///
/// VTK's mapper takes samples at equal distances until a ray is opaque. This library's skips what
/// is transparent, and takes longer where it is not, as its pictures are converged. Both are
/// counted along some columns of samples.
///
/// \return 0 if nothing is known of the volume
double BlendingTimeBesideVtk(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume);

}

#endif
