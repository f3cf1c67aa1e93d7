// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/SurfaceTracer.h"

namespace TemporalCoherence
{

std::shared_ptr<const SurfaceTracer> SurfaceTracer::Make(const TraceScene& scene)
{
  return scene.Samples.Kind->MakeTracer(scene);
}

void SurfaceTracer::FindNext(const RayBatch& rays, HitBatch& hits) const
{
  hits.Clear(rays.Count);
}

std::uint64_t SurfaceTracer::SearchCells(const RayBatch&, const RayCells& cells, HitBatch&) const
{
  return cells.Rays;
}

}
