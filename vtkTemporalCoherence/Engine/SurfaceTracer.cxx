// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTracer.h"

#include "CellRoot.h"
#include "CellWalk.h"
#include "KernelsCrossing.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

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
    const glm::i64vec3& s = this->Samples.Strides;
    for (const double isovalue : scene.Sought.Isovalues)
    {
      this->Differences.emplace_back(isovalue, scene.FiniteRange);
    }
    this->CornerOffsets = { 0, s.x, s.y, s.x + s.y, s.z, s.x + s.z, s.y + s.z, s.x + s.y + s.z };
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    Progress progress(rays, hits);
    if (this->IsSolid)
    {
      this->FindCaps(progress);
    }
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.Begin[ray] < rays.End[ray] && rays.WalkBegin[ray] < rays.WalkEnd[ray] &&
        hits.Kind[ray] == HitKind::None)
      {
        progress.Walks[ray].Begin({ rays, ray }, this->Cells);
        progress.Live[progress.NumberOfLive++] = ray;
      }
    }
    // In each round every ray that has not hit yet goes to the next cell that can hold a surface,
    // and all these cells are searched together.
    while (progress.NumberOfLive > 0)
    {
      this->AdvanceAll(progress);
      this->Search(progress);
      progress.DropHits();
    }
  }

private:
  /// The rays of a batch on their way.
  struct Progress
  {
    Progress(const RayBatch& rays, HitBatch& hits)
      : Rays(rays)
      , Hits(hits)
    {
      hits.CellsRead = 0;
      for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
      {
        hits.Depth[ray] = Infinity;
        hits.Contact[ray] = Infinity;
        hits.FromInside[ray] = 0;
        hits.Surface[ray] = Frame::NoSurface;
        hits.Kind[ray] = HitKind::None;
      }
    }

    void DropHits()
    {
      std::size_t left = 0;
      for (std::size_t i = 0; i < this->NumberOfLive; ++i)
      {
        if (this->Hits.Kind[this->Live[i]] == HitKind::None)
        {
          this->Live[left++] = this->Live[i];
        }
      }
      this->NumberOfLive = left;
    }

    const RayBatch& Rays;
    HitBatch& Hits;
    std::array<CellWalk, RayBatch::Capacity> Walks;
    std::array<std::size_t, RayBatch::Capacity> Live; ///< rays without a hit
    std::size_t NumberOfLive = 0;

    PassageBatch<Real> Passages;                       ///< through the cells to be searched
    std::array<std::size_t, RayBatch::Capacity> Owner; ///< ray of each passage
    std::array<std::int16_t, RayBatch::Capacity> Surface;
  };

  /// Take every live ray to the next cell to be searched; rays whose walk ends are dropped.
  void AdvanceAll(Progress& progress) const
  {
    std::size_t left = 0;
    for (std::size_t i = 0; i < progress.NumberOfLive; ++i)
    {
      const std::size_t ray = progress.Live[i];
      if (this->Scene.Active ? this->AdvanceToActive(ray, progress)
                             : this->AdvanceThroughAll(ray, progress))
      {
        progress.Live[left++] = ray;
      }
    }
    progress.NumberOfLive = left;
    for (std::size_t i = 0; i < left && this->Scene.Active && this->IsLarge; ++i)
    {
      this->Visit(progress.Live[i], progress);
    }
  }

  bool AdvanceToActive(std::size_t ray, Progress& progress) const
  {
    CellWalk& walk = progress.Walks[ray];
    const bool isAhead =
      walk.FindActive({ progress.Rays, ray }, *this->Scene.Active, this->Samples,
        [](std::int64_t, int) { return true; });
    if (isAhead && !this->IsLarge)
    {
      this->Visit(ray, progress);
    }
    else if (isAhead)
    {
      // Visited when all rays are there: until then the samples are on their way.
      const T* const origin = this->Samples.At(walk.Here());
      hwy::Prefetch(origin);
      hwy::Prefetch(origin + this->CornerOffsets[2]);
      hwy::Prefetch(origin + this->CornerOffsets[4]);
      hwy::Prefetch(origin + this->CornerOffsets[6]);
    }
    return isAhead;
  }

  bool AdvanceThroughAll(std::size_t ray, Progress& progress) const
  {
    bool isAhead;
    do
    {
      isAhead = progress.Walks[ray].FindAny({ progress.Rays, ray }, this->Cells);
    } while (isAhead && !this->Visit(ray, progress));
    return isAhead;
  }

  /// Read a cell, and take note of the passages through it that must be searched.
  /// \return false if no isovalue passes through the cell
  bool Visit(std::size_t ray, Progress& progress) const
  {
    const glm::ivec3& cell = progress.Walks[ray].Here();
    const std::array<T, 8> samples = this->Read(cell);
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

  std::array<T, 8> Read(const glm::ivec3& cell) const
  {
    const T* origin = this->Samples.At(cell);
    std::array<T, 8> samples;
    for (std::size_t i = 0; i < 8; ++i)
    {
      samples[i] = origin[this->CornerOffsets[i]];
    }
    return samples;
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
    const auto at = static_cast<std::size_t>(passages.Count++);
    for (std::size_t a = 0; a < 3; ++a)
    {
      passages.Origin[a][at] = progress.Rays.Origin[a][ray];
      passages.Direction[a][at] = progress.Rays.Direction[a][ray];
      passages.Inverse[a][at] = progress.Rays.Inverse[a][ray];
      passages.Cell[a][at] = cell[static_cast<int>(a)];
    }
    passages.Begin[at] = progress.Rays.Begin[ray];
    passages.End[at] = progress.Rays.End[ray];
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      passages.Corners[corner][at] = corners[corner];
    }
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
      if (passages.Distance[i] < progress.Hits.Depth[ray])
      {
        progress.Hits.Depth[ray] = passages.Distance[i];
        progress.Hits.Surface[ray] = progress.Surface[i];
        progress.Hits.Kind[ray] = IsInside(passages.AtEntry[i]) ? HitKind::Leaves : HitKind::Enters;
      }
    }
    passages.Count = 0;
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
          const BatchRay way{ rays, ray };
          glm::ivec3 cell;
          for (int axis = 0; axis < 3; ++axis)
          {
            cell[axis] = way.CellAt(axis, rays.Begin[ray], 0, this->Cells[axis] - 1);
          }
          Corners<Real> corners;
          this->Differ(this->Read(cell), this->Differences[surface], corners);
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
  TypedField<T> Samples;
  std::vector<Difference<T>> Differences; ///< from each isovalue
  glm::ivec3 Cells;                       ///< number of cells along each axis
  bool IsSolid;
  bool IsLarge;
  bool AreCellsActive; ///< the one isovalue passes through every cell that is visited
  std::array<std::int64_t, 8> CornerOffsets;
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
