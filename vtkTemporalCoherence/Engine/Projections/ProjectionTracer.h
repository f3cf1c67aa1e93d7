// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ProjectionTracer_h
#define TemporalCoherence_ProjectionTracer_h

#include "Blending/BlendTracer.h"
#include "Projections/ExtremeSearch.h"
#include "Sampling/ComponentSegment.h"
#include "Scene/GridCoordinates.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of a maximum or a minimum. Its colour and opacity are those of the value,
/// without light. Of several components that are independent, each has an extreme; else that of the
/// one that gives the opacity counts, and the colour is that of its place. A ray that meets no cell
/// shows nothing.
/// \param grid where samples lie; null: at integers
/// \param make the search in a component
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeExtremeTracer(
  const BlendScene& scene, const GridCoordinates* grid, ExtremeSearchMaker make);

/// The same of samples at a fixed distance.
std::shared_ptr<const BlendTracer> MakeSampledExtremes(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make);

}

#endif
