// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformBlending_h
#define TemporalCoherence_UniformBlending_h

#include "Blending/BlendTracer.h"
#include "Scene/GridCoordinates.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of a volume of samples at the corners of boxes, by its mode.
/// \param grid where samples lie; null: at integers
/// \return null if there is none
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeUniformBlendTracer(
  const BlendScene& scene, const GridCoordinates* grid = nullptr);

}

#endif
