// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ShareTracer_h
#define TemporalCoherence_ShareTracer_h

#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Samples/ComponentSegment.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of an average or of a sum, as VTK's shader shows them: opacity times value, as a
/// share of the scalar range, averaged over the part of the ray where the value lies in a range, or
/// summed up over unit distances. The result is an opaque grey; an average of nothing is invisible.
/// \param grid where samples lie; null: at integers
/// \param make the source of segments
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeShareTracer(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make);

}

#endif
