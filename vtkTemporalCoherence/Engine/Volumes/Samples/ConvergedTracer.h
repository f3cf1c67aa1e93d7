// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ConvergedTracer_h
#define TemporalCoherence_ConvergedTracer_h

#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Samples/ComponentSegment.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of composite volumes of any number of components and any kind of cells, whose
/// pictures converge.
/// \param grid where samples lie; null: at integers
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeConvergedTracer(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make);

}

#endif
