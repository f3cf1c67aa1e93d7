// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampledTracer_h
#define TemporalCoherence_SampledTracer_h

#include "Blending/BlendTracer.h"
#include "Sampling/ComponentSegment.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of a composite volume of any kind: several components, nearest interpolation,
/// any grid, and samples at a fixed distance. Without such a distance, each part of a cell between
/// bends of the functions is halved until nothing changes.
/// \param grid where samples lie; null: at integers
/// \param make the source of segments
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeSampledTracer(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make);

}

#endif
