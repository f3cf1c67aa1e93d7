// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GradedTracer_h
#define TemporalCoherence_GradedTracer_h

#include "Trace/SurfaceTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// A tracer for a field whose samples lie at coordinates: the same surfaces as that for uniform
/// fields, ray by ray and in double.
/// \pre scene.Samples.Grid
/// \throws std::bad_alloc
std::unique_ptr<SurfaceTracer> MakeGradedTracer(const TraceScene& scene);

}

#endif
