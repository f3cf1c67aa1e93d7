// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RectilinearTracer_h
#define TemporalCoherence_RectilinearTracer_h

#include "Fields/BeamChoice.h"
#include "Fields/RectilinearBeam.h"
#include "Trace/CellTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// CellTracer of a rectilinear field, where the rays of a tile go as a beam if that is faster.
template <typename T>
class RectilinearTracer final : public CellTracer<T, RectilinearCells<T>, Interpolation::Linear>
{
public:
  using Base = CellTracer<T, RectilinearCells<T>, Interpolation::Linear>;

  RectilinearTracer(const TraceScene& scene, const RectilinearCells<T>& shape)
    : Base(scene, shape)
  {
    if (scene.Active && scene.By != Traversal::Walks && HasBeams(scene.Samples, scene.Isosurfaces))
    {
      this->Levels = std::make_unique<const BeamLevels<double>>(scene);
    }
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.Clear(rays.Count);
    this->FindCaps(rays, hits);
    std::uint64_t wanted = 0;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      const bool isWanted = rays.HasWalk(ray) && hits.Kind[ray] == HitKind::None;
      wanted |= static_cast<std::uint64_t>(isWanted) << ray;
    }
    if (!(this->Levels && AreBeam(this->Cells.Scene, rays, wanted) &&
          RectilinearBeam<T>(this->Cells, *this->Levels, rays, hits).Trace(wanted)))
    {
      this->WalkAll(rays, hits);
    }
  }

private:
  std::unique_ptr<const BeamLevels<double>> Levels; ///< null: no beams
};

/// Make the tracer of a scene.
template <typename T>
std::shared_ptr<const SurfaceTracer> MakeRectilinearTracer(
  const TraceScene& scene, const RectilinearCells<T>& shape)
{
  if (scene.Samples.Between == Interpolation::Nearest)
  {
    return std::make_shared<CellTracer<T, RectilinearCells<T>, Interpolation::Nearest>>(
      scene, shape);
  }
  return std::make_shared<RectilinearTracer<T>>(scene, shape);
}

}

#endif
