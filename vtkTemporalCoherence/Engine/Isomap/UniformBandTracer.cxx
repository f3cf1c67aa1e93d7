// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/UniformBandTracer.h"

#include "Isomap/CellBandTracer.h"
#include "Isomap/UniformBandBeam.h"
#include "Lattice/BeamChoice.h"

#include <memory>

namespace TemporalCoherence
{
namespace
{

/// CellBandTracer that takes the rays of a tile as a beam where this is faster.
template <typename T>
class UniformBandTracer final : public CellBandTracer<T, UniformCells<T>, Interpolation::Linear>
{
public:
  using Base = CellBandTracer<T, UniformCells<T>, Interpolation::Linear>;
  using Progress = typename Base::Progress;
  using Base::Base;

  std::int64_t Trace(const RayBatch& rays, TileKnots& knots) const override
  {
    Progress progress(this->Cells, rays);
    std::uint64_t wanted = 0;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      const bool isWanted = rays.HasWalk(ray) && !progress.IsDone(ray);
      wanted |= static_cast<std::uint64_t>(isWanted) << ray;
    }
    if (!this->IsBeam(rays, wanted) ||
      !UniformBandBeam<T>(this->Cells, rays, progress).Trace(wanted))
    {
      this->Walk(rays, progress);
    }
    progress.HandOver(knots);
    return progress.CellsRead;
  }

private:
  bool IsBeam(const RayBatch& rays, std::uint64_t wanted) const
  {
    const BandScene& scene = this->Cells.Scene;
    return !scene.Samples.Hidden && AreBeam(scene.By, rays, wanted);
  }
};

}

std::shared_ptr<const BandTracer> MakeUniformBandTracer(const BandScene& scene)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type) -> std::shared_ptr<const BandTracer>
    {
      using T = decltype(type);
      if (scene.Samples.Between == Interpolation::Nearest)
      {
        return MakeCellBandTracer<T>(scene, UniformCells<T>());
      }
      return std::make_shared<UniformBandTracer<T>>(scene, UniformCells<T>());
    });
}

}
