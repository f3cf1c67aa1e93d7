// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellTracer_h
#define TemporalCoherence_CellTracer_h

#include "Lattice/LayerSearch.h"
#include "Lattice/SurfaceTracer.h"
#include "Lattice/TracedCells.h"

namespace TemporalCoherence
{

/// Traces fields with samples at the corners of cells: ray by ray, from cell to cell, for any
/// geometry of cells (TracedCells.h).
template <typename T, typename Geometry, Interpolation Between>
class CellTracer : public SurfaceTracer
{
public:
  CellTracer(const TraceScene& scene, const Geometry& shape)
    : Cells(scene, shape)
    , Layers(scene.Isosurfaces.Isovalues)
  {
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.Clear(rays.Count);
    this->FindCaps(rays, hits);
    this->WalkAll(rays, hits);
  }

  void FindNext(const RayBatch& rays, HitBatch& hits) const override
  {
    this->Layers.FindNext(this->Cells, rays, hits);
  }

  SearchedCells SearchCells(
    const RayBatch& rays, const RayCells& cells, HitBatch& hits) const override
  {
    const auto surface = static_cast<SurfaceIndex>(cells.Surface);
    std::uint64_t missing = 0;
    for (std::uint64_t left = cells.Rays; left != 0; left &= left - 1)
    {
      const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
      const glm::ivec3 cell = cells.At(ray);
      const Segment segment(this->Cells.Shape.RayOf(rays, ray), cell);
      const CellHit found = this->Cells.SearchFor(
        segment, this->Cells.Differ(this->Cells.Samples.Read(cell), cells.Surface));
      missing |= static_cast<std::uint64_t>(!std::isfinite(found.Distance)) << ray;
      this->Cells.Keep(segment, found, surface, ray, hits);
    }
    hits.CellsRead += static_cast<std::int64_t>(hwy::PopCount(cells.Rays));
    return { missing, 0 };
  }

protected:
  /// Cap solids that rays begin in.
  void FindCaps(const RayBatch& rays, HitBatch& hits) const
  {
    const bool mayBe = this->Cells.Rules.IsSolid() && rays.MayBeCapped;
    for (std::size_t ray = 0; mayBe && ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.Begin[ray] < rays.End[ray])
      {
        this->FindCap(rays, ray, hits);
      }
    }
  }

  /// Let all rays without a hit walk.
  void WalkAll(const RayBatch& rays, HitBatch& hits) const
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.HasWalk(ray) && hits.Kind[ray] == HitKind::None)
      {
        this->Walk(rays, ray, hits);
      }
    }
  }

  TracedCells<T, Geometry, Between> Cells;
  LayerSearch<T, Geometry, Between> Layers;

private:
  using Real = typename Geometry::Real;
  using Segment = typename Geometry::Segment;

  /// Walk from cell to cell up to the first hit.
  void Walk(const RayBatch& rays, std::size_t ray, HitBatch& hits) const
  {
    const auto line = this->Cells.Shape.RayOf(rays, ray);
    CellWalk walk;
    walk.Begin(line, this->Cells.Count);
    while (hits.Kind[ray] == HitKind::None && this->Cells.GoOn(line, walk))
    {
      ++hits.CellsRead;
      if (!this->Cells.IsHidden(walk.Here()))
      {
        this->Visit(line, walk.Here(), ray, hits);
      }
    }
  }

  /// Search a cell for the isovalues that pass through it.
  template <typename WalkingRay>
  void Visit(const WalkingRay& line, const glm::ivec3& cell, std::size_t ray, HitBatch& hits) const
  {
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell);
    for (std::size_t i = 0; i < this->Cells.Differences.size(); ++i)
    {
      const Corners<Real> corners = this->Cells.Differ(samples, i);
      if (!this->Cells.CanHold(corners))
      {
        continue;
      }
      const auto surface = static_cast<SurfaceIndex>(i);
      const Segment segment(line, cell);
      const CellHit found = this->Cells.SearchFor(segment, corners);
      this->Cells.Keep(segment, found, surface, ray, hits);
    }
  }

  void FindCap(const RayBatch& rays, std::size_t ray, HitBatch& hits) const
  {
    const auto line = this->Cells.Shape.RayOf(rays, ray);
    const glm::ivec3 cell = line.CellAt(rays.Begin[ray], this->Cells.Count);
    if (this->Cells.IsHidden(cell))
    {
      return;
    }
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell);
    const Segment segment(line, cell);
    for (std::size_t i = 0; i < this->Cells.Differences.size(); ++i)
    {
      if (IsInside(this->Cells.AtEntry(this->Cells.Differ(samples, i), segment)))
      {
        this->Cells.Rules.CapWhereItBegins(
          rays.Begin[ray], static_cast<SurfaceIndex>(i), ray, hits);
      }
    }
  }
};

}

#endif
