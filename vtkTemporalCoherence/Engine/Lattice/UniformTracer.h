// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformTracer_h
#define TemporalCoherence_UniformTracer_h

#include "Lattice/SurfaceTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// The tracer of uniform fields, for the type of the scene's samples: the rays of a tile go from
/// active cell to active cell together, in vectors.
/// \throws std::bad_alloc
std::shared_ptr<const SurfaceTracer> MakeUniformTracer(const TraceScene& scene);

}

#endif
