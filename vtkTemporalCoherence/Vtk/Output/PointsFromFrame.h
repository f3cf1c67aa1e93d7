// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PointsFromFrame_h
#define TemporalCoherence_PointsFromFrame_h

#include "Scene/Frame.h"
#include "Scene/FrameKey.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Make points of the hits of a frame, row by row from below. Each is a vertex with normal,
/// isovalue, the position of the isovalue in the property's list, and colour.
/// \param key    of the frame
/// \param places position in the property's list of each isovalue of the frame
/// \throws std::bad_alloc; `points` is then unchanged
void WritePoints(
  const Frame& frame, const FrameKey& key, const std::vector<int>& places, vtkPolyData* points);

}

#endif
