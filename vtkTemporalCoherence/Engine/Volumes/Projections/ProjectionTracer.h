// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ProjectionTracer_h
#define TemporalCoherence_ProjectionTracer_h

#include "Scene/GridCoordinates.h"
#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Projections/ExtremeSearch.h"
#include "Volumes/Samples/ComponentSegment.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of a maximum or a minimum. The transfer function gives colour and opacity of the
/// extreme, without light. Independent components have an extreme each. Dependent components show
/// their colour at the extreme of the component that gives the opacity. A ray that meets no cell
/// shows nothing.
/// \param grid where samples lie; null: at integers
/// \param make the search in a component
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeExtremeTracer(
  const BlendScene& scene, const GridCoordinates* grid, ExtremeSearchMaker make);

/// Make a tracer of the extremes of samples at a fixed distance.
std::shared_ptr<const BlendTracer> MakeSampledExtremes(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make);

}

#endif
