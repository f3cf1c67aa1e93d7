// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerSearch_h
#define TemporalCoherence_LayerSearch_h

#include "Lattice/TracedCells.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace TemporalCoherence
{

/// Finds the next surface along rays: SurfaceTracer::FindNext. The only state is the last surface,
/// so that the next one depends on the ray and on that surface alone.
template <typename T, typename Geometry, Interpolation Between>
class LayerSearch
{
public:
  using Cells = TracedCells<T, Geometry, Between>;

  /// \param isovalues of the scene of the cells that are searched
  explicit LayerSearch(const std::vector<double>& isovalues)
    : Isovalues(isovalues)
    , Ascending(isovalues.size())
  {
    std::iota(this->Ascending.begin(), this->Ascending.end(), std::size_t(0));
    std::sort(this->Ascending.begin(), this->Ascending.end(),
      [&](std::size_t a, std::size_t b) { return isovalues[a] < isovalues[b]; });
  }

  void FindNext(const Cells& cells, const RayBatch& rays, HitBatch& hits) const
  {
    RayBatch rest = rays;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      NextHit next(cells.Rules, LastOn(cells.Rules, rays.Begin[ray], ray, hits));
      const auto consider = [&next](double distance, HitKind kind, SurfaceIndex surface)
      { next.Consider(distance, kind, surface); };
      if (rays.Begin[ray] < rays.End[ray])
      {
        const double last = next.Before().Distance;
        if (cells.Rules.IsSolid() && rays.MayBeCapped && last <= rays.Begin[ray])
        {
          const glm::ivec3 cell = cells.Shape.RayOf(rays, ray).CellAt(rays.Begin[ray], cells.Count);
          if (this->MayHoldSolid(cells, cell))
          {
            this->FindCaps(cells, rays, ray, cell, consider);
          }
        }
        if (!next.IsFound())
        {
          rest.WalkBegin[ray] = std::max(rays.WalkBegin[ray], last);
          this->Walk(cells, rest, ray, next, hits);
        }
      }
      next.Store(ray, hits);
    }
  }

  /// Call consider(distance, kind, surface) for all surfaces in a cell.
  template <typename Consider>
  void Search(const Cells& cells, const typename Cells::Segment& segment,
    const std::array<T, 8>& samples, const Consider& consider) const
  {
    const bool isBehindHidden =
      cells.Rules.AreCappedBehindHidden() && segment.ComesFrom(*cells.Hidden);
    const auto [first, behind] = this->FindPassed(samples, isBehindHidden);
    for (std::size_t place = first; place < behind; ++place)
    {
      const std::size_t surface = this->Ascending[place];
      const Corners<Real> corners = cells.Differ(samples, surface);
      const auto inside = std::count_if(corners.begin(), corners.end(), IsInside<Real>);
      if (inside != 0 && (inside != 8 || isBehindHidden))
      {
        this->SearchFor(surface, cells.Rules.IsSolid(), corners, segment, isBehindHidden, consider);
      }
    }
  }

  /// True if a cell is visible and may contain a part of a solid.
  bool MayHoldSolid(const Cells& cells, const glm::ivec3& cell) const
  {
    if (cells.IsHidden(cell))
    {
      return false;
    }
    const auto [first, behind] = this->FindPassed(cells.Samples.Read(cell), true);
    return first != behind;
  }

  /// Call consider(distance, kind, surface) for all solids that are capped where a ray begins.
  /// \param cell in which it begins
  /// \pre MayHoldSolid
  template <typename Consider>
  void FindCaps(const Cells& cells, const RayBatch& rays, std::size_t ray, const glm::ivec3& cell,
    const Consider& consider) const
  {
    const std::array<T, 8> samples = cells.Samples.Read(cell);
    const auto [first, behind] = this->FindPassed(samples, true);
    const Segment segment(cells.Shape.RayOf(rays, ray), cell);
    for (std::size_t place = first; place < behind; ++place)
    {
      const std::size_t surface = this->Ascending[place];
      if (IsInside(Cells::AtEntry(cells.Differ(samples, surface), segment)))
      {
        consider(rays.Begin[ray], HitKind::Cap, static_cast<SurfaceIndex>(surface));
      }
    }
  }

private:
  using Real = typename Cells::Real;
  using Segment = typename Cells::Segment;

  /// The range in Ascending of the isovalues that may pass through a cell: from its smallest
  /// sample, or from the lowest isovalue, up to its largest sample. NaN is below all isovalues.
  std::pair<std::size_t, std::size_t> FindPassed(
    const std::array<T, 8>& samples, bool withLess) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low = infinity, high = -infinity;
    for (const T sample : samples)
    {
      const double value = static_cast<double>(sample);
      const double ranked = value == value ? value : -infinity;
      low = std::min(low, ranked);
      high = std::max(high, ranked);
    }
    const auto placeOf = [&](double value, auto isBefore)
    {
      const auto found = std::partition_point(this->Ascending.begin(), this->Ascending.end(),
        [&](std::size_t i) { return isBefore(this->Isovalues[i], value); });
      return static_cast<std::size_t>(found - this->Ascending.begin());
    };
    return { withLess ? 0 : placeOf(low, std::less<>()), placeOf(high, std::less_equal<>()) };
  }

  /// Walk from cell to cell until there is a surface behind the last one.
  void Walk(
    const Cells& cells, const RayBatch& rays, std::size_t ray, NextHit& next, HitBatch& hits) const
  {
    if (!rays.HasWalk(ray))
    {
      return;
    }
    const auto line = cells.Shape.RayOf(rays, ray);
    CellWalk walk;
    walk.Begin(line, cells.Count);
    while (!next.IsFound() && cells.GoOn(line, walk))
    {
      if (!cells.IsHidden(walk.Here()))
      {
        ++hits.CellsRead;
        this->Search(cells, Segment(line, walk.Here()), cells.Samples.Read(walk.Here()),
          [&next](double distance, HitKind kind, SurfaceIndex surface)
          { next.Consider(distance, kind, surface); });
      }
    }
  }

  /// Consider the surfaces of one isovalue in a cell.
  template <typename Consider>
  void SearchFor(std::size_t surface, bool isSolid, const Corners<Real>& corners,
    const Segment& segment, bool isBehindHidden, const Consider& found) const
  {
    const auto number = static_cast<SurfaceIndex>(surface);
    Cubic<Real> cubic;
    bool isInside;
    if constexpr (Between == Interpolation::Linear)
    {
      cubic = CubicAlong(corners, segment.Path());
      isInside = IsInside(cubic[0]);
    }
    else
    {
      isInside = IsInside(Cells::AtEntry(corners, segment));
    }
    if (isInside && isBehindHidden)
    {
      found(segment.Enter(), HitKind::Cap, number);
    }
    const auto consider = [&](double share)
    {
      isInside = !isInside;
      if (isInside || !isSolid)
      {
        found(segment.DistanceAt(share), HitRules::KindOf(!isInside), number);
      }
      return false;
    };
    if constexpr (Between == Interpolation::Linear)
    {
      VisitCrossings(cubic, [&](Real share) { return consider(static_cast<double>(share)); });
    }
    else if (segment.HasLength())
    {
      VisitNearestCrossings(corners, segment.Nearest(), consider);
    }
  }

  std::vector<double> Isovalues;
  std::vector<std::size_t>
    Ascending; ///< positions of the isovalues in the list, by ascending value
};

}

#endif
