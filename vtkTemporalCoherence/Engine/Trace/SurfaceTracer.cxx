// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/SurfaceTracer.h"

#include "Scene/Difference.h"
#include "Scene/HitOrder.h"
#include "Trace/CellRoot.h"
#include "Trace/CellSamples.h"
#include "Trace/CellWalk.h"
#include "Trace/GradedTracer.h"
#include "Trace/HiddenPassage.h"
#include "Trace/KernelsCrossing.h"
#include "Trace/KernelsWalk.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

template <typename T, Interpolation Between>
class TypedTracer final
  : public SurfaceTracer
  , private LeafSource
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
    , Hidden(scene.Samples.Hidden.get())
  {
    for (const double isovalue : scene.Sought.Isovalues)
    {
      this->Differences.emplace_back(isovalue, scene.FiniteRange);
    }
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.Clear(rays.Count);
    if (this->IsSolid)
    {
      this->FindCaps(rays, hits);
    }
    if (this->Scene.Active)
    {
      this->TraceActive(rays, hits);
    }
    else
    {
      this->TraceAll(rays, hits);
    }
  }

  std::uint64_t SearchCells(
    const RayBatch& rays, const CellList& cells, HitBatch& hits) const override
  {
    PassageBatch<Real> passages;
    SetPassages(rays, cells, passages);
    this->ReadCorners(this->Differences[cells.Surface], true, passages);
    hits.CellsRead += cells.Count;
    this->FindInPassages(passages);
    std::uint64_t missing = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
    {
      const std::size_t ray = cells.Ray[i];
      if (cells.IsContact[i])
      {
        KeepContact(passages, i, ray, hits);
      }
      missing |= static_cast<std::uint64_t>(!std::isfinite(passages.Distance[i])) << ray;
      this->KeepFirst(passages, i, ray, static_cast<std::int16_t>(cells.Surface), hits);
    }
    return missing;
  }

private:
  /// Passages to be searched, each of a ray that may have others.
  struct Search
  {
    PassageBatch<Real> Passages;
    RayBatch::Array<std::size_t> Ray; ///< in the batch that is traced
    RayBatch::Array<std::int16_t> Surface;
  };

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Scene.Active->CellsOf(this->Samples.All(), node, cell);
  }

  /// From active cell to active cell: in each round every ray that has not hit yet goes to the
  /// next, and all these cells are searched together.
  void TraceActive(const RayBatch& rays, HitBatch& hits) const
  {
    std::uint64_t wanted = 0;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      const bool isWanted = rays.HasWalk(ray) && hits.Kind[ray] == HitKind::None;
      wanted |= static_cast<std::uint64_t>(isWanted) << ray;
    }
    RayWalks walks(rays, wanted);
    PassageBatch<Real> passages;
    passages.All = &walks.Rays;
    while (walks.Rays.Count > 0)
    {
      FindActiveCells({ *this->Scene.Active, *this, this->Cells }, walks);
      hits.CellsRead += walks.Rays.Count;
      if (this->AreCellsActive)
      {
        this->SearchAll(walks, passages, hits);
      }
      else
      {
        this->SearchEach(walks, hits);
      }
    }
  }

  /// Search the cells that rays have gone to, through all of which the one isovalue passes.
  void SearchAll(RayWalks& walks, PassageBatch<Real>& passages, HitBatch& hits) const
  {
    const auto count = static_cast<std::size_t>(walks.Rays.Count);
    passages.Count = walks.Rays.Count;
    for (std::size_t a = 0; a < 3; ++a)
    {
      std::copy_n(walks.Cell[a].begin(), count, passages.Cell[a].begin());
    }
    this->ReadCorners(this->Differences[0], false, passages);
    this->FindInPassages(passages);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto ray = static_cast<std::size_t>(walks.From[i]);
      KeepContact(passages, i, ray, hits);
      KeepNearest(passages, i, ray, 0, hits);
    }
    for (std::size_t i = 0; i < count && this->IsCapped(); ++i)
    {
      this->CapBehindHidden(passages, i, static_cast<std::size_t>(walks.From[i]), 0, hits);
    }
    std::copy_n(passages.Distance.begin(), count, walks.Distance.begin());
  }

  /// Search the cells that rays have gone to, each for those isovalues that pass through it.
  void SearchEach(RayWalks& walks, HitBatch& hits) const
  {
    Search search;
    const auto count = static_cast<std::size_t>(walks.Rays.Count);
    const auto cellAt = [&walks](std::size_t i)
    { return glm::ivec3(walks.Cell[0][i], walks.Cell[1][i], walks.Cell[2][i]); };
    for (std::size_t i = 0; i < count && this->IsLarge; ++i)
    {
      this->Samples.Prefetch(cellAt(i));
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Visit(walks.Rays, i, cellAt(i), static_cast<std::size_t>(walks.From[i]), search, hits);
    }
    this->Finish(search, hits);
    for (std::size_t i = 0; i < count; ++i)
    {
      walks.Distance[i] = hits.Depth[static_cast<std::size_t>(walks.From[i])];
    }
  }

  /// From cell to cell, all of which are read.
  void TraceAll(const RayBatch& rays, HitBatch& hits) const
  {
    LiveRays live;
    live.Begin(rays, this->Cells, [&](std::size_t ray) { return hits.Kind[ray] == HitKind::None; });
    Search search;
    while (live.Count > 0)
    {
      live.Keep(
        [&](std::size_t ray)
        {
          CellWalk& walk = live.Walks[ray];
          bool isAhead;
          do
          {
            isAhead = walk.FindAny(BatchRay{ rays, ray }, this->Cells);
            hits.CellsRead += isAhead;
          } while (isAhead && !this->Visit(rays, ray, walk.Here(), ray, search, hits));
          return isAhead;
        });
      this->Finish(search, hits);
      live.Keep([&](std::size_t ray) { return hits.Kind[ray] == HitKind::None; });
    }
  }

  /// Read a cell, and take note of the passages of a ray through it that must be searched.
  /// \return false if no isovalue passes through the cell, or it is hidden
  bool Visit(const RayBatch& rays, std::size_t place, const glm::ivec3& cell, std::size_t ray,
    Search& search, HitBatch& hits) const
  {
    if (this->Hidden && this->Hidden->IsHidden(cell))
    {
      return false;
    }
    const std::array<T, 8> samples = this->Samples.Read(cell);
    bool isFound = false;
    for (std::size_t surface = 0; surface < this->Differences.size(); ++surface)
    {
      Corners<Real> corners;
      if (this->Differ(samples, this->Differences[surface], corners))
      {
        if (search.Passages.Count == RayBatch::Capacity)
        {
          this->Finish(search, hits);
        }
        const auto at = static_cast<std::size_t>(search.Passages.Count);
        AppendPassage(rays, place, cell, corners, search.Passages);
        search.Ray[at] = ray;
        search.Surface[at] = static_cast<std::int16_t>(surface);
        isFound = true;
      }
    }
    return isFound;
  }

  /// Differences of a cell's samples from an isovalue.
  /// \return false if all are on the same side, so that there is no surface
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
    return inside != 0 && (inside != 8 || this->IsCapped());
  }

  /// Search all noted passages; of several surfaces along a ray the nearest is its hit.
  void Finish(Search& search, HitBatch& hits) const
  {
    PassageBatch<Real>& passages = search.Passages;
    this->FindInPassages(passages);
    for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
    {
      KeepContact(passages, i, search.Ray[i], hits);
      this->KeepFirst(passages, i, search.Ray[i], search.Surface[i], hits);
      if (this->IsCapped())
      {
        this->CapBehindHidden(passages, i, search.Ray[i], search.Surface[i], hits);
      }
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

  /// Read the corners of the passages' cells, as differences from an isovalue.
  /// \param forNormals most of these cells will hold hits, which are shaded next
  void ReadCorners(
    const Difference<T>& difference, bool forNormals, PassageBatch<Real>& passages) const
  {
    const auto count = static_cast<std::size_t>(passages.Count);
    const auto cellAt = [&passages](std::size_t i)
    { return glm::ivec3(passages.Cell[0][i], passages.Cell[1][i], passages.Cell[2][i]); };
    for (std::size_t i = 0; i < count && this->IsLarge; ++i)
    {
      if (forNormals)
      {
        PrefetchAround(this->Samples.All(), cellAt(i));
      }
      else
      {
        this->Samples.Prefetch(cellAt(i));
      }
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
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        passages.Corners[corner][i] = difference(samples[corner][i]);
      }
    }
  }

  /// Make the beginning of a passage the contact of its ray if it is nearer.
  static void KeepContact(
    const PassageBatch<Real>& passages, std::size_t i, std::size_t ray, HitBatch& hits)
  {
    if (passages.Enter[i] < hits.Contact[ray])
    {
      hits.Contact[ray] = passages.Enter[i];
      hits.FromInside[ray] = IsInside(passages.AtEntry[i]);
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

  /// The same for one of several isovalues, some of which may be met at the same distance.
  void KeepFirst(const PassageBatch<Real>& passages, std::size_t i, std::size_t ray,
    std::int16_t surface, HitBatch& hits) const
  {
    if (passages.Distance[i] == hits.Depth[ray] && hits.Surface[ray] != Frame::NoSurface)
    {
      const auto isovalueOf = [this](std::int16_t of)
      { return this->Scene.Sought.Isovalues[static_cast<std::size_t>(of)]; };
      const HitKind kind = IsInside(passages.AtEntry[i]) ? HitKind::Leaves : HitKind::Enters;
      if (IsInFront({ hits.Depth[ray], kind, isovalueOf(surface) },
            { hits.Depth[ray], hits.Kind[ray], isovalueOf(hits.Surface[ray]) }))
      {
        hits.Surface[ray] = surface;
        hits.Kind[ray] = kind;
      }
      return;
    }
    KeepNearest(passages, i, ray, surface, hits);
  }

  /// True if hidden cells may cut a solid open.
  bool IsCapped() const { return this->Hidden && this->IsSolid; }

  /// A solid that a ray is inside of where it leaves hidden cells is capped there. Of several
  /// isovalues the highest is the one that is seen.
  void CapBehindHidden(PassageBatch<Real>& passages, std::size_t i, std::size_t ray,
    std::int16_t surface, HitBatch& hits) const
  {
    const double t = passages.Enter[i];
    const std::vector<double>& isovalues = this->Scene.Sought.Isovalues;
    const MetSurface cap{ t, HitKind::Cap, isovalues[static_cast<std::size_t>(surface)] };
    if (IsInFrontOfHit(cap, hits, ray, isovalues) && IsInside(passages.AtEntry[i]) &&
      ComesFromHidden(passages, i, t, *this->Hidden))
    {
      passages.Distance[i] = t;
      hits.Depth[ray] = t;
      hits.Surface[ray] = surface;
      hits.Kind[ray] = HitKind::Cap;
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
  void FindCaps(const RayBatch& rays, HitBatch& hits) const
  {
    const std::vector<double>& isovalues = this->Scene.Sought.Isovalues;
    Search search;
    PassageBatch<Real>& passages = search.Passages;
    for (std::size_t surface = 0; surface < isovalues.size(); ++surface)
    {
      for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
      {
        if (rays.Begin[ray] < rays.End[ray])
        {
          const glm::ivec3 cell = BatchRay{ rays, ray }.CellAt(rays.Begin[ray], this->Cells);
          if (this->Hidden && this->Hidden->IsHidden(cell))
          {
            continue;
          }
          Corners<Real> corners;
          this->Differ(this->Samples.Read(cell), this->Differences[surface], corners);
          search.Ray[static_cast<std::size_t>(passages.Count)] = ray;
          AppendPassage(rays, ray, cell, corners, passages);
        }
      }
      this->FindInPassages(passages);
      for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
      {
        const std::size_t ray = search.Ray[i];
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
  bool AreCellsActive;       ///< the one isovalue passes through every cell that is visited
  const HiddenCells* Hidden; ///< null for none
};

}

std::unique_ptr<SurfaceTracer> SurfaceTracer::Make(const TraceScene& scene)
{
  if (scene.Samples.Grid)
  {
    return MakeGradedTracer(scene);
  }
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
