// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SegmentSources_h
#define TemporalCoherence_SegmentSources_h

#include "Volumes/Samples/ComponentSegment.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the source of segments in an image or a rectilinear grid.
/// \param grid where samples lie; null: at integers
/// \throws std::bad_alloc
std::unique_ptr<const SegmentSource> MakeSegmentSource(
  const BlendScene& scene, const GridCoordinates* grid);

}

#endif
