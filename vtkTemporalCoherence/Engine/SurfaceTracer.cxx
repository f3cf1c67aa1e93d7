// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTracer.h"

#include "CellRoot.h"
#include "CellSamples.h"
#include "CellWalk.h"
#include "KernelsCrossing.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

template <typename T, Interpolation Between>
class TypedTracer final : public SurfaceTracer
{
public:
  using Real = RealOf<T>;

  explicit TypedTracer(const TraceScene& scene)
    : Scene(scene)
    , Samples(scene.Samples)
    , Cells(scene.Samples.Dimensions - 1)
    , IsSolid(scene.Sought.Mode == SurfaceMode::Threshold)
    , IsLarge(scene.Samples.IsLarge())
    , AreCellsActive(scene.Active && scene.Sought.Isovalues.size() == 1)
  {
    for (const double isovalue : scene.Sought.Isovalues)
    {
      this->Differences.emplace_back(isovalue, scene.FiniteRange);
    }
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    Progress progress(rays, hits);
    if (this->IsSolid)
    {
      this->FindCaps(progress);
    }
    const auto hasNoHit = [&hits](std::size_t ray) { return hits.Kind[ray] == HitKind::None; };
    progress.Live.Begin(rays, this->Cells, hasNoHit);
    // In each round every ray that has not hit yet goes to the next cell that can hold a surface,
    // and all these cells are searched together.
    while (progress.Live.Count > 0)
    {
      this->AdvanceAll(progress);
      this->Search(progress);
      progress.Live.Keep(hasNoHit);
    }
  }

  std::uint64_t SearchCells(
    const RayBatch& rays, const CellList& cells, HitBatch& hits) const override
  {
    PassageBatch<Real> passages;
    SetPassages(rays, cells, passages);
    this->ReadCorners(cells, passages);
    hits.CellsRead += cells.Count;
    this->FindInPassages(passages);
    std::uint64_t missing = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
    {
      const std::size_t ray = cells.Ray[i];
      if (cells.IsContact[i] && passages.Enter[i] < hits.Contact[ray])
      {
        hits.Contact[ray] = passages.Enter[i];
        hits.FromInside[ray] = IsInside(passages.AtEntry[i]);
      }
      missing |= static_cast<std::uint64_t>(!std::isfinite(passages.Distance[i])) << ray;
      KeepNearest(passages, i, ray, static_cast<std::int16_t>(cells.Surface), hits);
    }
    return missing;
  }

private:
  /// The rays of a batch on their way.
  struct Progress
  {
    Progress(const RayBatch& rays, HitBatch& hits)
      : Rays(rays)
      , Hits(hits)
    {
      hits.Clear(rays.Count);
    }

    const RayBatch& Rays;
    HitBatch& Hits;
    LiveRays Live; ///< rays without a hit

    PassageBatch<Real> Passages;                       ///< through the cells to be searched
    std::array<std::size_t, RayBatch::Capacity> Owner; ///< ray of each passage
    std::array<std::int16_t, RayBatch::Capacity> Surface;
  };

  /// Take every live ray to the next cell to be searched; rays whose walk ends are dropped.
  void AdvanceAll(Progress& progress) const
  {
    progress.Live.Keep(
      [&](std::size_t ray)
      {
        return this->Scene.Active ? this->AdvanceToActive(ray, progress)
                                  : this->AdvanceThroughAll(ray, progress);
      });
    for (std::size_t i = 0; i < progress.Live.Count && this->Scene.Active && this->IsLarge; ++i)
    {
      this->Visit(progress.Live.Rays[i], progress);
    }
  }

  bool AdvanceToActive(std::size_t ray, Progress& progress) const
  {
    CellWalk& walk = progress.Live.Walks[ray];
    const bool isAhead =
      walk.FindActive({ progress.Rays, ray }, *this->Scene.Active, this->Samples.All());
    if (isAhead && !this->IsLarge)
    {
      this->Visit(ray, progress);
    }
    else if (isAhead)
    {
      // Visited when all rays are there: until then the samples are on their way.
      this->Samples.Prefetch(walk.Here());
    }
    return isAhead;
  }

  bool AdvanceThroughAll(std::size_t ray, Progress& progress) const
  {
    bool isAhead;
    do
    {
      isAhead = progress.Live.Walks[ray].FindAny({ progress.Rays, ray }, this->Cells);
    } while (isAhead && !this->Visit(ray, progress));
    return isAhead;
  }

  /// Read a cell, and take note of the passages through it that must be searched.
  /// \return false if no isovalue passes through the cell
  bool Visit(std::size_t ray, Progress& progress) const
  {
    const glm::ivec3& cell = progress.Live.Walks[ray].Here();
    const std::array<T, 8> samples = this->Samples.Read(cell);
    ++progress.Hits.CellsRead;
    bool isFound = false;
    for (std::size_t surface = 0; surface < this->Differences.size(); ++surface)
    {
      Corners<Real> corners;
      if (this->Differ(samples, this->Differences[surface], corners))
      {
        this->Append(cell, corners, surface, ray, progress);
        isFound = true;
      }
    }
    return isFound;
  }

  /// Differences of a cell's samples from an isovalue.
  /// \return false if all are on the same side
  bool Differ(
    const std::array<T, 8>& samples, const Difference<T>& difference, Corners<Real>& corners) const
  {
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = difference(samples[i]);
    }
    if (this->AreCellsActive)
    {
      return true;
    }
    int inside = 0;
    for (std::size_t i = 0; i < 8; ++i)
    {
      inside += IsInside(corners[i]);
    }
    return inside != 0 && inside != 8;
  }

  void Append(const glm::ivec3& cell, const Corners<Real>& corners, std::size_t surface,
    std::size_t ray, Progress& progress) const
  {
    PassageBatch<Real>& passages = progress.Passages;
    if (passages.Count == RayBatch::Capacity)
    {
      this->Search(progress);
    }
    const auto at = static_cast<std::size_t>(passages.Count);
    AppendPassage(progress.Rays, ray, cell, corners, passages);
    progress.Owner[at] = ray;
    progress.Surface[at] = static_cast<std::int16_t>(surface);
  }

  /// Search all noted passages; of several surfaces along a ray the nearest is its hit.
  void Search(Progress& progress) const
  {
    PassageBatch<Real>& passages = progress.Passages;
    this->FindInPassages(passages);
    for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
    {
      const std::size_t ray = progress.Owner[i];
      if (passages.Enter[i] < progress.Hits.Contact[ray])
      {
        progress.Hits.Contact[ray] = passages.Enter[i];
        progress.Hits.FromInside[ray] = IsInside(passages.AtEntry[i]);
      }
      KeepNearest(passages, i, ray, progress.Surface[i], progress.Hits);
    }
    passages.Count = 0;
  }

  /// The passages of rays through the given cells.
  static void SetPassages(const RayBatch& rays, const CellList& cells, PassageBatch<Real>& passages)
  {
    const auto count = static_cast<std::size_t>(cells.Count);
    passages.Count = cells.Count;
    for (std::size_t a = 0; a < 3; ++a)
    {
      std::copy_n(cells.Cell[a].begin(), count, passages.Cell[a].begin());
    }
    if (cells.Count == RayBatch::Capacity)
    {
      passages.All = &rays;
      return;
    }
    const auto gather = [&](const auto& from, auto& to)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        to[i] = from[cells.Ray[i]];
      }
    };
    for (std::size_t a = 0; a < 3; ++a)
    {
      gather(rays.Origin[a], passages.Origin[a]);
      gather(rays.Direction[a], passages.Direction[a]);
      gather(rays.Inverse[a], passages.Inverse[a]);
    }
    gather(rays.Begin, passages.Begin);
    gather(rays.End, passages.End);
  }

  /// The corners of the given cells as differences from the isovalue.
  void ReadCorners(const CellList& cells, PassageBatch<Real>& passages) const
  {
    const auto count = static_cast<std::size_t>(cells.Count);
    const auto cellAt = [&cells](std::size_t i)
    { return glm::ivec3(cells.Cell[0][i], cells.Cell[1][i], cells.Cell[2][i]); };
    for (std::size_t i = 0; i < count && this->IsLarge; ++i)
    {
      // Most of these cells will hold hits, which are shaded next.
      PrefetchAround(this->Samples.All(), cellAt(i));
    }
    std::array<RayBatch::Array<T>, 8> samples;
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::array<T, 8> corners = this->Samples.Read(cellAt(i));
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        samples[corner][i] = corners[corner];
      }
    }
    const Difference<T> difference = this->Differences[cells.Surface];
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        passages.Corners[corner][i] = difference(samples[corner][i]);
      }
    }
  }

  /// Make what was found in a passage the hit of its ray if it is nearer.
  static void KeepNearest(const PassageBatch<Real>& passages, std::size_t i, std::size_t ray,
    std::int16_t surface, HitBatch& hits)
  {
    if (passages.Distance[i] < hits.Depth[ray])
    {
      hits.Depth[ray] = passages.Distance[i];
      hits.Surface[ray] = surface;
      hits.Kind[ray] = IsInside(passages.AtEntry[i]) ? HitKind::Leaves : HitKind::Enters;
    }
  }

  void FindInPassages(PassageBatch<Real>& passages) const
  {
    if constexpr (Between == Interpolation::Linear)
    {
      FindCrossings(passages, this->IsSolid);
    }
    else
    {
      FindNearestCrossings(passages);
    }
  }

  /// A solid that a ray begins in is capped there. Of several isovalues the highest is the one
  /// that is seen.
  void FindCaps(Progress& progress) const
  {
    const std::vector<double>& isovalues = this->Scene.Sought.Isovalues;
    const RayBatch& rays = progress.Rays;
    HitBatch& hits = progress.Hits;
    for (std::size_t surface = 0; surface < isovalues.size(); ++surface)
    {
      PassageBatch<Real>& passages = progress.Passages;
      for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
      {
        if (rays.Begin[ray] < rays.End[ray])
        {
          const glm::ivec3 cell = BatchRay{ rays, ray }.CellAt(rays.Begin[ray], this->Cells);
          Corners<Real> corners;
          this->Differ(this->Samples.Read(cell), this->Differences[surface], corners);
          this->Append(cell, corners, surface, ray, progress);
        }
      }
      this->FindInPassages(passages);
      for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
      {
        const std::size_t ray = progress.Owner[i];
        const bool isHighest = hits.Surface[ray] == Frame::NoSurface ||
          isovalues[surface] > isovalues[static_cast<std::size_t>(hits.Surface[ray])];
        if (isHighest && IsInside(passages.AtEntry[i]))
        {
          hits.Depth[ray] = rays.Begin[ray];
          hits.Contact[ray] = rays.Begin[ray];
          hits.Surface[ray] = static_cast<std::int16_t>(surface);
          hits.Kind[ray] = HitKind::Cap;
        }
      }
      passages.Count = 0;
    }
  }

  TraceScene Scene;
  CellSamples<T> Samples;
  std::vector<Difference<T>> Differences; ///< from each isovalue
  glm::ivec3 Cells;                       ///< number of cells along each axis
  bool IsSolid;
  bool IsLarge;
  bool AreCellsActive; ///< the one isovalue passes through every cell that is visited
};

}

std::unique_ptr<SurfaceTracer> SurfaceTracer::Make(const TraceScene& scene)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type) -> std::unique_ptr<SurfaceTracer>
    {
      using T = decltype(type);
      if (scene.Samples.Between == Interpolation::Nearest)
      {
        return std::make_unique<TypedTracer<T, Interpolation::Nearest>>(scene);
      }
      return std::make_unique<TypedTracer<T, Interpolation::Linear>>(scene);
    });
}

}
