// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampledTracer_h
#define TemporalCoherence_SampledTracer_h

#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Samples/ComponentSegment.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of a composite volume of any kind, from samples at a fixed distance.
/// \param grid where samples lie; null: at integers
/// \param make the source of segments
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeSampledTracer(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make);

}

#endif
