// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerTracer.h"

#include "CellSamples.h"
#include "CellWalk.h"
#include "HiddenPassage.h"
#include "HitOrder.h"
#include "Passage.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A surface, and its position in the list.
struct FoundSurface
{
  MetSurface Met{ Infinity, HitKind::None, 0.0 };
  std::int16_t Surface = Frame::NoSurface;
};

template <typename T, Interpolation Between>
class TypedLayerTracer final : public LayerTracer
{
public:
  using Real = RealOf<T>;

  explicit TypedLayerTracer(const TraceScene& scene)
    : Scene(scene)
    , Samples(scene.Samples)
    , Cells(scene.Samples.Dimensions - 1)
    , IsSolid(scene.Sought.Mode == SurfaceMode::Threshold)
  {
    for (const double isovalue : scene.Sought.Isovalues)
    {
      this->Differences.emplace_back(isovalue, scene.FiniteRange);
    }
  }

  void FindNext(const RayBatch& rays, HitBatch& hits) const override
  {
    RayBatch rest = rays;
    PassageBatch<Real> room;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      FoundSurface next;
      const FoundSurface last = this->LastOf(rays, ray, hits);
      if (rays.Begin[ray] < rays.End[ray])
      {
        if (this->IsSolid && last.Met.Distance <= rays.Begin[ray])
        {
          this->FindCap(rays, ray, last, room, next);
        }
        if (next.Surface == Frame::NoSurface)
        {
          rest.WalkBegin[ray] = std::max(rays.WalkBegin[ray], last.Met.Distance);
          this->Walk(rest, ray, last, room, next, hits);
        }
      }
      hits.Depth[ray] = next.Met.Distance;
      hits.Kind[ray] = next.Met.Kind;
      hits.Surface[ray] = next.Surface;
    }
  }

private:
  FoundSurface LastOf(const RayBatch& rays, std::size_t ray, const HitBatch& hits) const
  {
    FoundSurface last;
    last.Surface = hits.Surface[ray];
    last.Met = { last.Surface == Frame::NoSurface ? -Infinity : hits.Depth[ray], hits.Kind[ray],
      this->IsovalueOf(last.Surface) };
    // What is known of an earlier piece of the ray does not matter to this one.
    if (last.Met.Distance < rays.Begin[ray])
    {
      last = FoundSurface();
      last.Met.Distance = -Infinity;
    }
    return last;
  }

  double IsovalueOf(int surface) const
  {
    return surface == Frame::NoSurface
      ? 0.0
      : this->Scene.Sought.Isovalues[static_cast<std::size_t>(surface)];
  }

  /// Take a surface if it is behind the last one and before the best so far.
  void Consider(double distance, HitKind kind, std::size_t surface, const FoundSurface& last,
    FoundSurface& next) const
  {
    const MetSurface met{ distance, kind, this->Scene.Sought.Isovalues[surface] };
    if (distance < Infinity && IsInFront(last.Met, met) && IsInFront(met, next.Met))
    {
      next = { met, static_cast<std::int16_t>(surface) };
    }
  }

  bool IsHidden(const glm::ivec3& cell) const
  {
    return this->Scene.Samples.Hidden && this->Scene.Samples.Hidden->IsHidden(cell);
  }

  /// Solids that are cut open where the ray begins.
  void FindCap(const RayBatch& rays, std::size_t ray, const FoundSurface& last,
    PassageBatch<Real>& room, FoundSurface& next) const
  {
    const glm::ivec3 cell = BatchRay{ rays, ray }.CellAt(rays.Begin[ray], this->Cells);
    if (this->IsHidden(cell))
    {
      return;
    }
    for (std::size_t surface = 0; surface < this->Differences.size(); ++surface)
    {
      const Passage<Real> passage =
        this->PassageOf(rays, ray, cell, this->Samples.Read(cell), surface, room);
      if (IsInside(this->AtEntry(passage)))
      {
        this->Consider(rays.Begin[ray], HitKind::Cap, surface, last, next);
      }
    }
  }

  /// From cell to cell until there is a surface behind the last one.
  void Walk(const RayBatch& rays, std::size_t ray, const FoundSurface& last,
    PassageBatch<Real>& room, FoundSurface& next, HitBatch& hits) const
  {
    if (!rays.HasWalk(ray))
    {
      return;
    }
    const BatchRay line{ rays, ray };
    CellWalk walk;
    walk.Begin(line, this->Cells);
    while (next.Surface == Frame::NoSurface &&
      (this->Scene.Active ? walk.FindActive(line, *this->Scene.Active, this->Samples.All())
                          : walk.FindAny(line, this->Cells)))
    {
      if (!this->IsHidden(walk.Here()))
      {
        ++hits.CellsRead;
        this->Search(rays, ray, walk.Here(), last, room, next);
      }
    }
  }

  /// All surfaces in a cell.
  void Search(const RayBatch& rays, std::size_t ray, const glm::ivec3& cell,
    const FoundSurface& last, PassageBatch<Real>& room, FoundSurface& next) const
  {
    const std::array<T, 8> samples = this->Samples.Read(cell);
    for (std::size_t surface = 0; surface < this->Differences.size(); ++surface)
    {
      const Passage<Real> passage = this->PassageOf(rays, ray, cell, samples, surface, room);
      bool isInside = IsInside(this->AtEntry(passage));
      if (isInside && this->IsSolid && this->Scene.Samples.Hidden &&
        ComesFromHidden(room, 0, passage.Enter, *this->Scene.Samples.Hidden))
      {
        this->Consider(passage.Enter, HitKind::Cap, surface, last, next);
      }
      const auto consider = [&](double share)
      {
        isInside = !isInside;
        if (isInside || !this->IsSolid)
        {
          this->Consider(passage.DistanceAt(share), isInside ? HitKind::Enters : HitKind::Leaves,
            surface, last, next);
        }
        return false;
      };
      if constexpr (Between == Interpolation::Linear)
      {
        VisitCrossings(CubicAlong(passage.Values, passage.Path),
          [&](Real share) { return consider(static_cast<double>(share)); });
      }
      else if (passage.Enter < passage.Leave)
      {
        VisitNearestCrossings(passage.Values, passage.Nearest(room, 0), consider);
      }
    }
  }

  Passage<Real> PassageOf(const RayBatch& rays, std::size_t ray, const glm::ivec3& cell,
    const std::array<T, 8>& samples, std::size_t surface, PassageBatch<Real>& room) const
  {
    Corners<Real> corners;
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = this->Differences[surface](samples[i]);
    }
    room.Count = 0;
    AppendPassage(rays, ray, cell, corners, room);
    return Passage<Real>(room, 0);
  }

  /// Difference from the isovalue where the ray enters the cell.
  static Real AtEntry(const Passage<Real>& passage)
  {
    return Between == Interpolation::Linear ? CubicAlong(passage.Values, passage.Path)[0]
                                            : passage.Values[NearestCorner(passage.Path.Begin)];
  }

  TraceScene Scene;
  CellSamples<T> Samples;
  std::vector<Difference<T>> Differences; ///< from each isovalue
  glm::ivec3 Cells;                       ///< number of cells along each axis
  bool IsSolid;
};

}

std::unique_ptr<LayerTracer> LayerTracer::Make(const TraceScene& scene)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type) -> std::unique_ptr<LayerTracer>
    {
      using T = decltype(type);
      if (scene.Samples.Between == Interpolation::Nearest)
      {
        return std::make_unique<TypedLayerTracer<T, Interpolation::Nearest>>(scene);
      }
      return std::make_unique<TypedLayerTracer<T, Interpolation::Linear>>(scene);
    });
}

}
