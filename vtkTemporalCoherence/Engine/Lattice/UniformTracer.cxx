// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/UniformTracer.h"

#include "Lattice/BeamChoice.h"
#include "Lattice/CellBeam.h"
#include "Lattice/CellLayerBeam.h"
#include "Lattice/KernelsBlocked.h"
#include "Lattice/KernelsCorners.h"
#include "Lattice/KernelsCrossing.h"
#include "Lattice/KernelsRays.h"
#include "Lattice/KernelsWalk.h"
#include "Lattice/UniformCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

namespace TemporalCoherence
{
namespace
{

/// Finds the first surfaces of the rays of a tile by a beam, in an image. The kernel of walks
/// searches cells.
template <typename T>
class UniformBeam final : public CellBeam<T, UniformCells<T>>
{
public:
  using Base = CellBeam<T, UniformCells<T>>;
  using Real = typename Base::Real;
  using Base::Base;

private:
  /// Segments to search.
  struct Search
  {
    SegmentBatch<Real> Segments;
    RayBatch::Array<std::size_t> Ray;
    RayBatch::Array<SurfaceIndex> Surface;
  };

  void Decide(OpenCells& open, TileBeam& beam) override
  {
    if (this->CountOfRead() == 0)
    {
      return;
    }
    this->DecideMet(beam);
    Search search;
    this->VisitOpen(open, beam,
      [&](std::size_t ray, const glm::ivec3& cell) { this->Visit(ray, cell, search, beam); });
    this->Finish(search, beam);
    this->ForgetCells(beam);
  }

  /// Compute the beam's certain hits in full precision.
  void DecideMet(TileBeam& beam)
  {
    SegmentBatch<Real> segments;
    const std::uint64_t met = this->TakeMet(this->Places, beam, segments);
    for (std::size_t isovalue = 0; isovalue < this->Given.Isovalues.size(); ++isovalue)
    {
      if (this->SetCorners(beam, met, isovalue, segments))
      {
        FindCrossings(segments, this->Cells.Rules.IsSolid());
        for (std::uint64_t left = segments.Wanted; left != 0; left &= left - 1)
        {
          const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
          this->Keep(segments, ray, static_cast<SurfaceIndex>(isovalue), ray, beam);
        }
      }
    }
  }

  /// Note a ray's segments in a cell, of each isovalue that passes through it.
  void Visit(std::size_t ray, const glm::ivec3& cell, Search& search, TileBeam& beam)
  {
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell);
    for (std::size_t surface = 0; surface < this->Given.Isovalues.size(); ++surface)
    {
      const Corners<Real> corners = this->Cells.Differ(samples, surface);
      if (!this->Cells.CanHold(corners))
      {
        continue;
      }
      if (search.Segments.Count == RayBatch::Capacity)
      {
        this->Finish(search, beam);
      }
      const auto at = static_cast<std::size_t>(search.Segments.Count);
      AppendSegment(this->Rays, ray, cell, corners, search.Segments);
      search.Ray[at] = ray;
      search.Surface[at] = static_cast<SurfaceIndex>(surface);
    }
  }

  /// Search the noted segments.
  void Finish(Search& search, TileBeam& beam)
  {
    SegmentBatch<Real>& segments = search.Segments;
    FindCrossings(segments, this->Cells.Rules.IsSolid());
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
    {
      this->Keep(segments, i, search.Surface[i], search.Ray[i], beam);
    }
    segments.Count = 0;
  }

  /// Keep the hit found in segment i, unless the ray enters another cell with a surface earlier.
  void Keep(const SegmentBatch<Real>& segments, std::size_t i, SurfaceIndex surface,
    std::size_t ray, TileBeam& beam)
  {
    const double enter = segments.Enter[i], distance = segments.Distance[i];
    if (!(distance < std::numeric_limits<double>::infinity() && enter <= this->FirstEnter[ray]))
    {
      return;
    }
    const bool fromInside = IsInside(segments.AtEntry[i]);
    if (enter < this->FirstEnter[ray])
    {
      this->FirstEnter[ray] = enter;
      this->Hits.Depth[ray] = distance;
      this->Hits.Surface[ray] = surface;
      this->Hits.Kind[ray] = HitRules::KindOf(fromInside);
      this->HideBehind(enter, ray, beam);
    }
    else // in the same cell
    {
      this->Cells.Rules.KeepFirst(distance, fromInside, surface, ray, this->Hits);
    }
    this->CapBehindHidden(segments, i, surface, ray);
  }

  /// Cap a solid where a ray inside it leaves hidden cells.
  void CapBehindHidden(
    const SegmentBatch<Real>& segments, std::size_t i, SurfaceIndex surface, std::size_t ray)
  {
    const double enter = segments.Enter[i];
    if (this->Cells.Rules.AreCappedBehindHidden() && IsInside(segments.AtEntry[i]))
    {
      this->Cells.Rules.CapBehindHidden(
        enter, surface, ray,
        [&] { return ComesFromHidden(segments, i, enter, *this->Cells.Hidden); }, this->Hits);
    }
  }
};

/// CellTracer with vector kernels that process all rays of a tile together.
template <typename T, Interpolation Between>
class UniformTracer final
  : public LayerBeamTracer<T, UniformCells<T>, Between>
  , private LeafSource
  , private VectorCellReader<RealOf<T>>
{
public:
  using Real = RealOf<T>;
  using Base = LayerBeamTracer<T, UniformCells<T>, Between>;

  explicit UniformTracer(const TraceScene& scene)
    : Base(scene, {})
    , IsLarge(scene.Samples.IsLarge())
    , AreCellsActive(scene.Active && scene.Isosurfaces.Isovalues.size() == 1)
  {
    if (HasBeams(scene))
    {
      this->Levels = std::make_unique<const BeamLevels<T>>(scene);
    }
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.Clear(rays.Count);
    if (this->Cells.Rules.IsSolid() && rays.MayBeCapped)
    {
      this->FindCaps(rays, hits);
    }
    if (this->Cells.Scene.Active)
    {
      this->TraceActive(rays, hits);
    }
    else
    {
      this->TraceAll(rays, hits);
    }
  }

  std::uint64_t FindBlocked(const RayBatch& rays, std::int64_t& cellsRead) const override
  {
    if (Between == Interpolation::Nearest || !this->Cells.Scene.Active ||
      this->Cells.Rules.AreCappedBehindHidden())
    {
      return Base::FindBlocked(rays, cellsRead);
    }
    return TemporalCoherence::FindBlocked(
      { { *this->Cells.Scene.Active, *this, this->Cells.Count }, *this,
        this->Cells.Differences.size(), this->Cells.Rules.IsSolid() },
      rays, cellsRead);
  }

  SearchedCells SearchCells(
    const RayBatch& rays, const RayCells& cells, HitBatch& hits) const override
  {
    SegmentBatch<Real> segments;
    segments.All = &rays;
    segments.Count = rays.Count;
    segments.Wanted = cells.Rays;
    for (std::size_t a = 0; a < 3; ++a)
    {
      std::copy(cells.Cell[a].begin(), cells.Cell[a].end(), segments.Cell[a].begin());
    }
    this->GatherCorners(this->Cells.Differences[cells.Surface], cells, segments);
    hits.CellsRead += static_cast<std::int64_t>(hwy::PopCount(cells.Rays));
    this->FindInSegments(segments);
    const auto surface = static_cast<SurfaceIndex>(cells.Surface);
    const bool isOnly = this->Cells.Differences.size() == 1;
    const bool areCapped = this->Cells.Rules.AreCappedBehindHidden();
    std::uint64_t missing = 0;
    for (std::uint64_t left = cells.Rays; left != 0; left &= left - 1)
    {
      const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
      const bool fromInside = IsInside(segments.AtEntry[ray]);
      const double distance = segments.Distance[ray];
      missing |= static_cast<std::uint64_t>(!std::isfinite(distance)) << ray;
      if (isOnly)
      {
        HitRules::KeepNearest(distance, fromInside, surface, ray, hits);
      }
      else
      {
        this->Cells.Rules.KeepFirst(distance, fromInside, surface, ray, hits);
      }
      if (areCapped)
      {
        this->CapBehindHidden(segments, ray, ray, surface, hits);
      }
    }
    return { missing, 0 };
  }

private:
  /// Segments to search. A ray may have several.
  struct Search
  {
    SegmentBatch<Real> Segments;
    RayBatch::Array<std::size_t> Ray; ///< in the batch that is traced
    RayBatch::Array<SurfaceIndex> Surface;
  };

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  void Read(std::size_t surface, VectorCells<Real>& cells) const override
  {
    const Difference<T> difference = this->Cells.Differences[surface];
    ForEachRay(cells.Which,
      [&](std::size_t lane)
      {
        const std::array<T, 8> samples = this->Cells.Samples.Read(
          glm::ivec3(cells.Cell[0][lane], cells.Cell[1][lane], cells.Cell[2][lane]));
        for (std::size_t corner = 0; corner < 8; ++corner)
        {
          cells.Corners[corner][lane] = difference(samples[corner]);
        }
      });
  }

  /// Walk from active cell to active cell: each round takes every ray without a hit to its next
  /// active cell, and searches all these cells together.
  void TraceActive(const RayBatch& rays, HitBatch& hits) const
  {
    const std::uint64_t wanted = WalksWithoutHit(rays, hits);
    if constexpr (Between == Interpolation::Linear)
    {
      if (this->Levels && AreBeam(this->Cells.Scene, rays, wanted) &&
        UniformBeam<T>(this->Cells, *this->Levels, rays, hits).Trace(wanted))
      {
        return;
      }
    }
    RayWalks walks(rays, wanted);
    SegmentBatch<Real> segments;
    segments.All = &walks.Rays;
    while (walks.Rays.Count > 0)
    {
      FindActiveCells({ *this->Cells.Scene.Active, *this, this->Cells.Count }, walks);
      hits.CellsRead += walks.Rays.Count;
      if (this->AreCellsActive)
      {
        this->SearchAll(walks, segments, hits);
      }
      else
      {
        this->SearchEach(walks, hits);
      }
    }
  }

  /// Search the rays' present cells, through all of which the only isovalue passes.
  void SearchAll(RayWalks& walks, SegmentBatch<Real>& segments, HitBatch& hits) const
  {
    const auto count = static_cast<std::size_t>(walks.Rays.Count);
    segments.Count = walks.Rays.Count;
    for (std::size_t a = 0; a < 3; ++a)
    {
      std::copy_n(walks.Cell[a].begin(), count, segments.Cell[a].begin());
    }
    this->ReadCorners(this->Cells.Differences[0], false, segments);
    this->FindInSegments(segments);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto ray = static_cast<std::size_t>(walks.From[i]);
      const bool fromInside = IsInside(segments.AtEntry[i]);
      HitRules::KeepNearest(segments.Distance[i], fromInside, 0, ray, hits);
    }
    const bool areCapped = this->Cells.Rules.AreCappedBehindHidden();
    for (std::size_t i = 0; i < count && areCapped; ++i)
    {
      this->CapBehindHidden(segments, i, static_cast<std::size_t>(walks.From[i]), 0, hits);
    }
    std::copy_n(segments.Distance.begin(), count, walks.Distance.begin());
  }

  /// Search the rays' present cells, each for the isovalues that pass through it.
  void SearchEach(RayWalks& walks, HitBatch& hits) const
  {
    Search search;
    const auto count = static_cast<std::size_t>(walks.Rays.Count);
    const auto cellAt = [&walks](std::size_t i)
    { return glm::ivec3(walks.Cell[0][i], walks.Cell[1][i], walks.Cell[2][i]); };
    for (std::size_t i = 0; i < count && this->IsLarge; ++i)
    {
      this->Cells.Samples.Prefetch(cellAt(i));
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

  /// Walk from cell to cell, and read every cell.
  void TraceAll(const RayBatch& rays, HitBatch& hits) const
  {
    const glm::ivec3& cells = this->Cells.Count;
    LiveRays live;
    live.Begin(rays, this->Cells.Shape, cells,
      [&](std::size_t ray) { return hits.Kind[ray] == HitKind::None; });
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
            isAhead = walk.FindAny(BatchRay{ rays, ray }, cells);
            hits.CellsRead += isAhead;
          } while (isAhead && !this->Visit(rays, ray, walk.Here(), ray, search, hits));
          return isAhead;
        });
      this->Finish(search, hits);
      live.Keep([&](std::size_t ray) { return hits.Kind[ray] == HitKind::None; });
    }
  }

  /// Read a cell, and take note of the segments of a ray through it that must be searched.
  /// \return false if no isovalue passes through the cell, or it is hidden
  bool Visit(const RayBatch& rays, std::size_t place, const glm::ivec3& cell, std::size_t ray,
    Search& search, HitBatch& hits) const
  {
    if (this->Cells.IsHidden(cell))
    {
      return false;
    }
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell);
    bool isFound = false;
    for (std::size_t surface = 0; surface < this->Cells.Differences.size(); ++surface)
    {
      const Corners<Real> corners = this->Cells.Differ(samples, surface);
      if (this->Cells.CanHold(corners))
      {
        if (search.Segments.Count == RayBatch::Capacity)
        {
          this->Finish(search, hits);
        }
        const auto at = static_cast<std::size_t>(search.Segments.Count);
        AppendSegment(rays, place, cell, corners, search.Segments);
        search.Ray[at] = ray;
        search.Surface[at] = static_cast<SurfaceIndex>(surface);
        isFound = true;
      }
    }
    return isFound;
  }

  /// Search all noted segments; of several surfaces along a ray the nearest is its hit.
  void Finish(Search& search, HitBatch& hits) const
  {
    SegmentBatch<Real>& segments = search.Segments;
    this->FindInSegments(segments);
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
    {
      const bool fromInside = IsInside(segments.AtEntry[i]);
      this->Cells.Rules.KeepFirst(
        segments.Distance[i], fromInside, search.Surface[i], search.Ray[i], hits);
      if (this->Cells.Rules.AreCappedBehindHidden())
      {
        this->CapBehindHidden(segments, i, search.Ray[i], search.Surface[i], hits);
      }
    }
    segments.Count = 0;
  }

  /// Read the corners of the rays' cells. Most of these cells will hold hits, which are shaded
  /// next.
  void GatherCorners(
    const Difference<T>& difference, const RayCells& cells, SegmentBatch<Real>& segments) const
  {
    if constexpr (sizeof(T) <= 2)
    {
      const Field& field = this->Cells.Scene.Samples;
      const std::array<double, 3> parts = difference.Parts();
      if (!this->IsLarge && NarrowSamples<T>::Are(field) &&
        GatherDifferences(NarrowSamples<T>(field), cells.Cell, field.Dimensions.x,
          static_cast<float>(parts[0]), static_cast<float>(parts[1]), segments.Corners))
      {
        return;
      }
    }
    this->ReadCorners(difference, true, segments);
  }

  /// Read the corners of the segments' cells, as differences from an isovalue.
  /// \param forNormals most of these cells will hold hits, which are shaded next
  void ReadCorners(
    const Difference<T>& difference, bool forNormals, SegmentBatch<Real>& segments) const
  {
    const auto count = static_cast<std::size_t>(segments.Count);
    const auto cellAt = [&segments](std::size_t i)
    { return glm::ivec3(segments.Cell[0][i], segments.Cell[1][i], segments.Cell[2][i]); };
    for (std::size_t i = 0; i < count && this->IsLarge; ++i)
    {
      if (forNormals)
      {
        PrefetchAround(this->Cells.Samples.All(), cellAt(i));
      }
      else
      {
        this->Cells.Samples.Prefetch(cellAt(i));
      }
    }
    CornerPairs<T> pairs;
    this->ReadPairs(segments, pairs);
    FindDifferences(pairs, count, difference, segments.Corners);
  }

  /// Read the corners of the segments' cells as they lie in memory.
  void ReadPairs(const SegmentBatch<Real>& segments, CornerPairs<T>& pairs) const
  {
    const auto count = static_cast<std::size_t>(segments.Count);
    // A local copy: stores of a character type may alias anything that is not local.
    const TypedField<T> samples = this->Cells.Samples.All();
    const std::array<std::int64_t, 4> rows = { 0, samples.Strides.y, samples.Strides.z,
      samples.Strides.y + samples.Strides.z };
    const std::int64_t toNext = samples.Strides.x;
    for (std::size_t i = 0; i < count; ++i)
    {
      const T* const origin = samples.At(static_cast<int>(segments.Cell[0][i]),
        static_cast<int>(segments.Cell[1][i]), static_cast<int>(segments.Cell[2][i]));
      for (std::size_t row = 0; row < 4; ++row)
      {
        const T* const from = origin + rows[row];
        if (toNext == 1)
        {
          std::memcpy(&pairs[row][i], from, 2 * sizeof(T));
        }
        else
        {
          pairs[row][i] = { from[0], from[toNext] };
        }
      }
    }
    // Leave no lane of the last vector uninitialised.
    for (std::size_t row = 0; row < 4 && sizeof(T) <= 2; ++row)
    {
      std::fill(pairs[row].begin() + segments.Count,
        pairs[row].begin() + static_cast<std::ptrdiff_t>(WholeVectors(count)), std::array<T, 2>());
    }
  }

  /// Cap a solid where a ray inside it leaves hidden cells.
  void CapBehindHidden(SegmentBatch<Real>& segments, std::size_t i, std::size_t ray,
    SurfaceIndex surface, HitBatch& hits) const
  {
    const double enter = segments.Enter[i];
    if (IsInside(segments.AtEntry[i]) &&
      this->Cells.Rules.CapBehindHidden(
        enter, surface, ray,
        [&] { return ComesFromHidden(segments, i, enter, *this->Cells.Hidden); }, hits))
    {
      segments.Distance[i] = enter;
    }
  }

  void FindInSegments(SegmentBatch<Real>& segments) const
  {
    if constexpr (Between == Interpolation::Linear)
    {
      FindCrossings(segments, this->Cells.Rules.IsSolid());
    }
    else
    {
      FindNearestCrossings(segments);
    }
  }

  /// CellTracer::FindCaps in vectors.
  void FindCaps(const RayBatch& rays, HitBatch& hits) const
  {
    Search search;
    SegmentBatch<Real>& segments = search.Segments;
    CellsOfRays cells;
    FindFirstCells(rays, this->Cells.Count, cells);
    for (std::size_t surface = 0; surface < this->Cells.Differences.size(); ++surface)
    {
      // Neighbouring rays often begin in one cell.
      glm::ivec3 last(-1);
      Corners<Real> corners{};
      bool canBeInside = false;
      for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
      {
        if (rays.Begin[ray] < rays.End[ray])
        {
          const glm::ivec3 cell(cells[0][ray], cells[1][ray], cells[2][ray]);
          if (cell != last)
          {
            last = cell;
            corners = this->Cells.Differ(this->Cells.Samples.Read(cell), surface);
            // If all corners are outside, the whole cell is: interpolation preserves signs.
            const Real largest = *std::max_element(corners.begin(), corners.end());
            canBeInside = IsInside(largest) && !this->Cells.IsHidden(cell);
          }
          if (canBeInside)
          {
            search.Ray[static_cast<std::size_t>(segments.Count)] = ray;
            AppendSegment(rays, ray, cell, corners, segments);
          }
        }
      }
      this->FindInSegments(segments);
      for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
      {
        if (IsInside(segments.AtEntry[i]))
        {
          this->Cells.Rules.CapWhereItBegins(
            rays.Begin[search.Ray[i]], static_cast<SurfaceIndex>(surface), search.Ray[i], hits);
        }
      }
      segments.Count = 0;
    }
  }

  bool IsLarge;
  bool AreCellsActive; ///< the one isovalue passes through every cell that is visited
  std::unique_ptr<const BeamLevels<T>> Levels; ///< null: no beams
};

}

std::shared_ptr<const SurfaceTracer> MakeUniformTracer(const TraceScene& scene)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type) -> std::shared_ptr<const SurfaceTracer>
    {
      using T = decltype(type);
      if (scene.Samples.Between == Interpolation::Nearest)
      {
        return std::make_shared<UniformTracer<T, Interpolation::Nearest>>(scene);
      }
      return std::make_shared<UniformTracer<T, Interpolation::Linear>>(scene);
    });
}

}
