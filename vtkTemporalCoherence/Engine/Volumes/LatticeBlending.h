// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LatticeBlending_h
#define TemporalCoherence_LatticeBlending_h

#include "Scene/GridCoordinates.h"
#include "Volumes/Beams/CompositeTables.h"
#include "Volumes/Medium/BlendTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of an image or a rectilinear grid, by the blend mode.
/// \param grid where samples lie; null: at integers
/// \return null if the mode has no tracer
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeLatticeBlendTracer(
  const BlendScene& scene, const GridCoordinates* grid = nullptr, KeptTables* kept = nullptr);

}

#endif
