// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellLayerBeam_h
#define TemporalCoherence_CellLayerBeam_h

#include "Lattice/BeamChoice.h"
#include "Lattice/CellTracer.h"
#include "Lattice/KernelsBeam.h"
#include "Lattice/LayerBeam.h"
#include "Lattice/LayerSearch.h"
#include "Lattice/TracedCells.h"
#include "Scene/HitOrder.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Finds layers of the rays of a tile by beams, in a field with samples at the corners of cells.
///
/// The beam only skips cells that a ray does not pass or where single precision proves a miss.
/// Other cells are searched with the arithmetic of a walk. Each ray meets its cells in order, so
/// its search ends where the ray is opaque.
template <typename T, typename Geometry>
class CellLayerBeam final : private LayerBeamScene<typename Geometry::Real>
{
public:
  using Real = typename Geometry::Real;
  using Traced = TracedCells<T, Geometry, Interpolation::Linear>;
  using Layers = LayerSearch<T, Geometry, Interpolation::Linear>;

  CellLayerBeam(const Traced& cells, const Layers& search, const GridCoordinates* grid)
    : Cells(cells)
    , Search(search)
    , Grid(grid)
  {
  }

  /// Append the layers of open rays that beams can handle. Other rays stay open.
  void Trace(const RayBatch& rays, LayerBatch& layers)
  {
    this->Rays = &rays;
    this->FindCaps(layers);
    RayBatch rest;
    this->Rays = this->BeginBehind(rays, layers, rest);
    std::uint64_t mustWalk = 0;
    for (std::uint64_t left = layers.Open; left != 0;)
    {
      const std::uint64_t which = this->AlikeIn(left);
      left &= ~which;
      mustWalk |= this->TraceSome(which, layers);
    }
    layers.Open = mustWalk;
  }

private:
  /// Selects rays whose direction has the same signs as the first ray's, one bit each.
  std::uint64_t AlikeIn(std::uint64_t rays) const
  {
    const auto signsOf = [this](std::size_t ray)
    {
      int signs = 0;
      for (std::size_t a = 0; a < 3; ++a)
      {
        signs |= static_cast<int>(this->Rays->Direction[a][ray] < 0.0) << a;
      }
      return signs;
    };
    const int first = signsOf(hwy::Num0BitsBelowLS1Bit_Nonzero64(rays));
    std::uint64_t alike = 0;
    ForEachRay(rays,
      [&](std::size_t ray) { alike |= static_cast<std::uint64_t>(signsOf(ray) == first) << ray; });
    return alike;
  }

  /// Begin the walks of open rays at their last surfaces.
  /// \return `rays` if no walk changes; else `rest`
  const RayBatch* BeginBehind(const RayBatch& rays, const LayerBatch& layers, RayBatch& rest) const
  {
    const RayBatch* found = &rays;
    ForEachRay(layers.Open,
      [&](std::size_t ray)
      {
        if (layers.LastDistance[ray] > rays.WalkBegin[ray])
        {
          if (found == &rays)
          {
            rest = rays;
            found = &rest;
          }
          rest.WalkBegin[ray] = layers.LastDistance[ray];
        }
      });
    return found;
  }

  /// \return one bit for each ray that must walk
  std::uint64_t TraceSome(std::uint64_t which, LayerBatch& layers)
  {
    TileBeam beam;
    const std::uint64_t open = layers.Open;
    layers.Open = 0;
    ForEachRay(which,
      [&](std::size_t ray)
      { layers.Open |= static_cast<std::uint64_t>(this->Rays->HasWalk(ray)) << ray; });
    std::uint64_t mustWalk = layers.Open;
    if (mustWalk != 0 && SetUpBeam(*this->Rays, mustWalk, this->Cells.Count, beam) && beam.AreAlike)
    {
      const LayerTask task{ *this->Cells.Scene.Active, *this->Rays, this->Cells.Rules.IsSolid(),
        this->Cells.Rules.AreCappedBehindHidden(), this->Grid };
      mustWalk = SearchLayers(task, *this, beam, layers);
      layers.CellsRead += beam.CellsPassed;
    }
    layers.Open = open;
    return mustWalk;
  }

  /// Append the caps of solids that rays begin in.
  void FindCaps(LayerBatch& layers)
  {
    if (!(this->Cells.Rules.IsSolid() && this->Rays->MayBeCapped))
    {
      return;
    }
    // Neighbouring rays often begin in one cell.
    glm::ivec3 last(-1);
    bool mayBeInside = false;
    ForEachRay(layers.Open,
      [&](std::size_t ray)
      {
        const double begin = this->Rays->Begin[ray];
        if (!(begin < this->Rays->End[ray]) || LastAt(begin, ray, layers) > begin)
        {
          return;
        }
        const glm::ivec3 cell =
          this->Cells.Shape.RayOf(*this->Rays, ray).CellAt(begin, this->Cells.Count);
        if (cell != last)
        {
          last = cell;
          mayBeInside = this->Search.MayHoldSolid(this->Cells, cell);
        }
        if (mayBeInside)
        {
          this->AppendCaps(ray, cell, layers);
        }
      });
  }

  void AppendCaps(std::size_t ray, const glm::ivec3& cell, LayerBatch& layers) const
  {
    CellSurfaces found;
    this->Search.FindCaps(this->Cells, *this->Rays, ray, cell,
      [&](double distance, HitKind kind, SurfaceIndex surface) {
        this->Insert({ distance, kind, surface }, ray, layers, found);
      });
    for (std::size_t i = 0; i < found.Count && layers.IsOpen(ray); ++i)
    {
      layers.Append(ray, this->Rays->Begin[ray], HitKind::Cap, found.All[i].Surface);
    }
  }

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  void Read(const glm::ivec3& cell, CellLevels<Real>& levels) override
  {
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell);
    levels.Count = 0;
    const std::size_t count = this->Cells.Differences.size();
    for (std::size_t surface = 0; surface < count && levels.AreAll(); ++surface)
    {
      CellLevel<Real>& level = levels.All[levels.Count];
      level.Surface = static_cast<SurfaceIndex>(surface);
      level.Corners = this->Cells.Differ(samples, surface);
      levels.Count += this->Cells.CanHold(level.Corners);
    }
  }

  void SearchCell(
    const glm::ivec3& cell, std::size_t ray, const LayerBatch& layers, CellSurfaces& found) override
  {
    const typename Geometry::Segment segment(this->Cells.Shape.RayOf(*this->Rays, ray), cell);
    if (segment.HasLength())
    {
      this->Search.Search(this->Cells, segment, this->Cells.Samples.Read(cell),
        [&](double distance, HitKind kind, SurfaceIndex surface) {
          this->Insert({ distance, kind, surface }, ray, layers, found);
        });
    }
  }

  MetSurface SurfaceOf(const CellSurfaces::Met& met) const
  {
    return { met.Distance, met.Kind, this->Cells.Rules.IsovalueOf(met.Surface) };
  }

  /// Insert a surface in front-to-back order, if it lies behind the ray's last surface.
  void Insert(const CellSurfaces::Met& met, std::size_t ray, const LayerBatch& layers,
    CellSurfaces& found) const
  {
    if (!this->IsBehindLast(met, this->Rays->Begin[ray], ray, layers))
    {
      return;
    }
    const MetSurface surface = this->SurfaceOf(met);
    std::size_t at = found.Count;
    while (at > 0 && IsInFront(surface, this->SurfaceOf(found.All[at - 1])))
    {
      --at;
    }
    const bool isKnown = at > 0 && !IsInFront(this->SurfaceOf(found.All[at - 1]), surface);
    if (isKnown || at == found.All.size() || !(met.Distance < Infinity))
    {
      return;
    }
    found.Count = std::min(found.Count + 1, found.All.size());
    std::copy_backward(found.All.begin() + static_cast<std::ptrdiff_t>(at),
      found.All.begin() + static_cast<std::ptrdiff_t>(found.Count) - 1,
      found.All.begin() + static_cast<std::ptrdiff_t>(found.Count));
    found.All[at] = met;
  }

  /// t of a ray's last surface; -infinity if the piece that begins at `begin` has no last surface.
  static double LastAt(double begin, std::size_t ray, const LayerBatch& layers)
  {
    const double last = layers.LastDistance[ray];
    return layers.LastSurface[ray] == Frame::NoSurface || last < begin ? -Infinity : last;
  }

  bool IsBehindLast(
    const CellSurfaces::Met& met, double begin, std::size_t ray, const LayerBatch& layers) const
  {
    return LastAt(begin, ray, layers) == -Infinity ||
      IsInFront(this->SurfaceOf(
                  { layers.LastDistance[ray], layers.LastKind[ray], layers.LastSurface[ray] }),
        this->SurfaceOf(met));
  }

  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  const Traced& Cells;
  const Layers& Search;
  const GridCoordinates* Grid; ///< of samples; null: they lie at integers
  const RayBatch* Rays = nullptr;
};

/// CellTracer that finds the layers of a tile's rays by beams where this is faster.
template <typename T, typename Geometry, Interpolation Between>
class LayerBeamTracer : public CellTracer<T, Geometry, Between>
{
public:
  using Base = CellTracer<T, Geometry, Between>;

  /// \param grid coordinates of samples; null: they lie at integers
  LayerBeamTracer(
    const TraceScene& scene, const Geometry& shape, const GridCoordinates* grid = nullptr)
    : Base(scene, shape)
    , Grid(grid)
    , CanGo(HasBeams(scene))
  {
  }

  bool FindsLayersTogether(const RayBatch& rays) const override
  {
    return this->CanGo && AreLayerBeam(this->Cells.Scene.By, rays, ~std::uint64_t(0));
  }

  void FindLayers(const RayBatch& rays, LayerBatch& layers) const override
  {
    if constexpr (Between == Interpolation::Linear)
    {
      if (this->CanGo && AreLayerBeam(this->Cells.Scene.By, rays, layers.Open))
      {
        CellLayerBeam<T, Geometry>(this->Cells, this->Layers, this->Grid).Trace(rays, layers);
      }
    }
    Base::FindLayers(rays, layers);
  }

private:
  const GridCoordinates* Grid;
  bool CanGo; ///< the scene supports beams
};

}

#endif
