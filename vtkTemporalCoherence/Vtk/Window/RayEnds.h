// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayEnds_h
#define TemporalCoherence_RayEnds_h

#include "Scene/View.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// For each ray of a frame, the t at which an opaque prop hides everything behind.
using RayEnds = std::shared_ptr<const std::vector<double>>;

/// Make the ends of rays from a depth buffer.
/// \param depths of the buffer, row by row from below: 0 at the near plane, 1 at the far plane
/// \param size   pixels of the buffer, which the frame fills; there may be more or fewer rays
/// \return null if all is background
/// \throws std::bad_alloc
RayEnds EndsAt(const std::vector<float>& depths, const glm::ivec2& size, const View& view);

/// Find the ends of rays at the props that a renderer has drawn in its window so far.
/// \param volume that is drawn
/// \param ends   receives them; null if no prop hides the volume
/// \return false if the window's depths cannot be read
/// \throws std::bad_alloc
bool FindRayEnds(vtkRenderer* renderer, vtkVolume* volume, const View& view, RayEnds& ends);

}

#endif
