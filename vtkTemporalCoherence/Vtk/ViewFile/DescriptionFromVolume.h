// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DescriptionFromVolume_h
#define TemporalCoherence_DescriptionFromVolume_h

#include "Acceleration/SurfaceHistogram.h"
#include "Scene/FrameKey.h"
#include "ViewFile/ViewDescription.h"
#include "vtkTemporalCoherenceCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Colours, material, lights and background of a frame's surfaces.
ViewLook LookOf(
  const FrameKey& key, const SurfaceHistogram& surfaces, vtkRenderer* renderer, vtkVolume* volume);

/// Where the rays of a frame go.
/// \param tolerance in voxels
ViewGeometry GeometryOf(const FrameKey& key, vtkRenderer* renderer, double tolerance);

}

#endif
