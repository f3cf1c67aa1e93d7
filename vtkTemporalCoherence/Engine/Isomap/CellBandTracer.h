// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellBandTracer_h
#define TemporalCoherence_CellBandTracer_h

#include "Isomap/BandProgress.h"
#include "Isomap/BandTracer.h"
#include "Lattice/CellWalk.h"

#include <cmath>
#include <memory>
#include <type_traits>

namespace TemporalCoherence
{

/// The BandTracer of fields with samples at the corners of cells, for any geometry of cells
/// (TracedCells.h): each ray walks from cell to cell.
template <typename T, typename Geometry, Interpolation Between>
class CellBandTracer : public BandTracer
{
public:
  using Real = typename Geometry::Real;
  using Value = typename Geometry::Value;
  using Progress = BandProgress<T, Geometry, Between>;

  CellBandTracer(const BandScene& scene, const Geometry& shape)
    : Cells(scene, shape)
  {
  }

  std::int64_t Trace(const RayBatch& rays, TileKnots& knots) const override
  {
    Progress progress(this->Cells, rays);
    this->Walk(rays, progress);
    progress.HandOver(knots);
    return progress.CellsRead;
  }

protected:
  /// Let all rays that are not done walk.
  void Walk(const RayBatch& rays, Progress& progress) const
  {
    LiveRays live;
    Round round;
    live.Begin(rays, this->Cells.Shape, this->Cells.Count,
      [&](std::size_t ray) { return !progress.IsDone(ray); });
    while (live.Count > 0 && !progress.IsTooLarge())
    {
      // Walk to the next cells that can raise the progress of rays.
      live.Keep([&](std::size_t ray)
        { return this->Advance(rays, ray, live.Walks[ray], round, progress); });
      round.Segments.Find(rays, this->Cells.Shape);
      const RangesView<Real> ranges = round.Segments.View();
      for (std::size_t i = 0; i < round.Segments.Count(); ++i)
      {
        progress.TakeNote(
          round.Segments.Owner[i], round.Segments.CellOf(i), round.Reach[i], ranges, i);
      }
      round.Segments.Clear();
      live.Keep([&](std::size_t ray) { return !progress.IsDone(ray); });
    }
  }

  BandCells<T, Geometry> Cells;

private:
  /// The present cells of the walking rays.
  struct Round
  {
    SegmentRanges<Geometry, Between> Segments;
    RayBatch::Array<CellReach<Real>> Reach;
  };

  /// A filter of blocks of cells that can raise a ray's progress.
  struct UsefulBlocks
  {
    bool IsOfUse(const ValueRangePyramid::Range<T>& range) const
    {
      constexpr Real infinity = BandCells<T, Geometry>::Infinity;
      Real highest = this->Cells.FromLowest(static_cast<Value>(range.Max));
      Real lowest = this->Cells.FromLowest(static_cast<Value>(range.Min));
      if constexpr (std::is_floating_point_v<T>)
      {
        // A sample that is not finite bounds no progress, in a block as in a cell.
        highest = std::isfinite(range.Max) ? highest : infinity;
        lowest = std::isfinite(range.Min) ? lowest : -infinity;
      }
      return this->Reached.CanBringOn(this->Ray, highest, this->Cells.Span - lowest);
    }
    bool IsNodeOfUse(std::int64_t node) const
    {
      return this->IsOfUse(this->Cells.Scene.Pyramid->template NodeAt<T>(node));
    }
    bool IsLeafOfUse(std::int64_t node, int leaf) const
    {
      return this->IsOfUse(this->Cells.Scene.Pyramid->template LeavesOf<T>(node)[leaf]);
    }

    const BandCells<T, Geometry>& Cells;
    const Progress& Reached;
    std::size_t Ray;
  };

  /// Walk to the next cell that can raise a ray's progress.
  /// \return false if its walk ends first
  bool Advance(
    const RayBatch& rays, std::size_t ray, CellWalk& walk, Round& round, Progress& progress) const
  {
    const UsefulBlocks useful{ this->Cells, progress, ray };
    const auto line = this->Cells.Shape.RayOf(rays, ray);
    while (walk.FindActive(line, *this->Cells.Scene.Active, this->Cells.Samples.All(), useful))
    {
      Corners<Real> corners;
      const CellReach<Real> reach = this->Cells.Read(walk.Here(), corners);
      ++progress.CellsRead;
      if (progress.CanBringOn(ray, reach.Corner[Rising], reach.Corner[Falling]))
      {
        round.Reach[round.Segments.Count()] = reach;
        round.Segments.Append(rays, ray, walk.Here(), corners);
        return true;
      }
    }
    return false;
  }
};

/// Make the tracer of a scene for a geometry.
template <typename T, typename Geometry>
std::shared_ptr<const BandTracer> MakeCellBandTracer(const BandScene& scene, const Geometry& shape)
{
  if (scene.Samples.Between == Interpolation::Nearest)
  {
    return std::make_shared<CellBandTracer<T, Geometry, Interpolation::Nearest>>(scene, shape);
  }
  return std::make_shared<CellBandTracer<T, Geometry, Interpolation::Linear>>(scene, shape);
}

}

#endif
