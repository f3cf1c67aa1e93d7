// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelTracer_h
#define TemporalCoherence_LabelTracer_h

#include "Lattice/SmoothLabels.h"
#include "Lattice/SurfaceTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// The tracer of an image of labels. The isovalues are the labels that are drawn. A ray meets a
/// label where it comes to it from another label, begins in it, or comes to it from hidden cells.
/// Where a ray leaves a label it meets nothing.
/// \param smooth surfaces between labels; null: labels are made of the voxels around their samples
/// \throws std::bad_alloc
std::shared_ptr<const SurfaceTracer> MakeLabelTracer(
  const TraceScene& scene, std::shared_ptr<const SmoothLabels> smooth);

}

#endif
