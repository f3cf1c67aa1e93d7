// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceTracer_h
#define TemporalCoherence_SurfaceTracer_h

#include "ActiveCells.h"
#include "Field.h"
#include "RayBatch.h"
#include "Surfaces.h"

namespace TemporalCoherence
{

/// What rays are traced through.
struct TraceScene
{
  Field Samples;
  Surfaces Sought;
  glm::dvec2 FiniteRange{ 0.0 };       ///< smallest and largest finite sample
  const ActiveCells* Active = nullptr; ///< null: no space leaping, every cell on the way is read
};

/// Find the first surface along each ray.
///
/// A ray goes from cell to cell; in each cell that can hold a surface the first crossing is found
/// exactly (CellRoot.h). The hit is the nearest over all isovalues. The result depends on the ray,
/// its Begin and its End, and not on where the walk starts or what is leapt over.
void TraceSurfaces(const TraceScene& scene, const RayBatch& rays, HitBatch& hits);

}

#endif
