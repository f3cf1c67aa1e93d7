// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandProgress_h
#define TemporalCoherence_BandProgress_h

#include "Acceleration/HiddenCells.h"
#include "Isomap/BandCells.h"
#include "Isomap/KnotCollector.h"
#include "Trace/KernelsRange.h"
#include "Trace/SegmentBatch.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{

/// How far the rays of a tile have come through a band, and the knots that follow.
///
/// Whoever takes the rays through active cells appends the cells that can bring a ray on, those of
/// each ray in their order along it. They are measured together, and then taken note of. Others
/// change nothing.
template <typename T, typename Geometry, Interpolation Between>
class BandProgress
{
public:
  using Cells = BandCells<T, Geometry>;
  using Real = typename Geometry::Real;

  /// Progress of a ray through the band in one direction.
  struct Reach
  {
    Real Path = -Cells::Infinity;   ///< progress of the field along the ray
    Real Corner = -Cells::Infinity; ///< progress of the samples around it
    BandScale::Key PathKey = 0, CornerKey = 0;
    bool IsDone = false;
  };

  BandProgress(const Cells& band, const RayBatch& rays)
    : Band(band)
    , Rays(rays)
    , Knots(rays, band.Scene.Form, band.Scale)
  {
    this->Entries.fill(-std::numeric_limits<float>::infinity());
    this->Entered.fill(false);
    if (band.IsSolid)
    {
      this->FindEntries();
    }
  }

  /// True if nothing ahead of a ray matters.
  bool IsDone(std::size_t ray) const
  {
    return this->Reached[Rising][ray].IsDone && this->Reached[Falling][ray].IsDone;
  }

  /// True if progress like this would be more than a ray has made.
  bool CanBringOn(std::size_t ray, Real toRise, Real toFall) const
  {
    const Reach &rises = this->Reached[Rising][ray], &falls = this->Reached[Falling][ray];
    return (!rises.IsDone && toRise > rises.Path) || (!falls.IsDone && toFall > falls.Path);
  }

  const Reach& ReachOf(std::size_t direction, std::size_t ray) const
  {
    return this->Reached[direction][ray];
  }

  /// True if the value where a ray begins is known.
  bool HasEntered(std::size_t ray) const { return this->Entered[ray]; }

  /// True if the knots exceed the limit.
  bool IsTooLarge() const { return this->Knots.MemoryInBytes() > this->Band.Scene.MemoryLimit; }

  void Append(std::size_t ray, const glm::ivec3& cell, const Corners<Real>& corners,
    const CellReach<Real>& reach)
  {
    const auto at = static_cast<std::size_t>(this->Segments.Count);
    AppendSegment(this->Rays, ray, cell, corners, this->Segments);
    this->Owner[at] = ray;
    this->Corner[at] = reach;
  }

  /// Append the cells of some rays at once, when none is appended.
  /// \param rays, cellOf of each, the ray and what Append takes: its Place, Corners and Reach
  template <typename Places, typename CellOf>
  void AppendAll(std::size_t count, const Places& rays, const CellOf& cellOf)
  {
    SegmentBatch<Real>& segments = this->Segments;
    segments.Count = static_cast<int>(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto& cell = cellOf(i);
      this->Owner[i] = rays[i];
      this->Corner[i] = cell.Reach;
      for (std::size_t a = 0; a < 3; ++a)
      {
        segments.Cell[a][i] = cell.Place[static_cast<int>(a)];
      }
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        segments.Corners[corner][i] = cell.Corners[corner];
      }
    }
    GatherRays(this->Rays, rays, segments);
  }

  void Measure()
  {
    if constexpr (!Geometry::HasKernels)
    {
      for (std::size_t i = 0; i < static_cast<std::size_t>(this->Segments.Count); ++i)
      {
        this->MeasureOne(i);
      }
    }
    else if constexpr (Between == Interpolation::Linear)
    {
      FindRanges(this->Segments, this->Ranges);
    }
    else
    {
      FindNearestRanges(this->Segments, this->Ranges);
    }
  }

  /// Take note of what was measured. Cells that cannot bring a ray on, after all, are left out.
  /// \param isOnWay tells of a ray and the segment appended as the i-th whether the ray's walk goes
  ///                through its cell
  template <typename IsOnWay>
  void TakeNote(const IsOnWay& isOnWay)
  {
    for (std::size_t i = 0; i < static_cast<std::size_t>(this->Segments.Count); ++i)
    {
      const std::size_t ray = this->Owner[i];
      const CellReach<Real>& cell = this->Corner[i];
      if (this->CanBringOn(ray, cell.Corner[Rising], cell.Corner[Falling]) && isOnWay(ray, i))
      {
        this->TakeNoteOf(i, ray);
      }
    }
    this->Segments.Count = 0;
  }

  /// Where segment i enters its cell and leaves it, and the cell.
  double EnterOf(std::size_t i) const { return this->Segments.Enter[i]; }
  double LeaveOf(std::size_t i) const { return this->Ranges.Leave[i]; }
  glm::ivec3 CellOf(std::size_t i) const
  {
    return { this->Segments.Cell[0][i], this->Segments.Cell[1][i], this->Segments.Cell[2][i] };
  }

  /// Hand the knots over. Nothing can be done with this afterwards.
  /// \throws std::bad_alloc
  void HandOver(TileKnots& knots)
  {
    const BandScene& scene = this->Band.Scene;
    this->Knots.HandOver(scene.Samples, scene.FiniteRange, scene.Transform, knots);
    if (this->HasEntries)
    {
      knots.Entries.assign(this->Entries.begin(), this->Entries.begin() + this->Rays.Count);
    }
  }

  std::int64_t CellsRead = 0;

private:
  /// FindRanges and FindNearestRanges, for one segment.
  void MeasureOne(std::size_t i)
  {
    SegmentBatch<Real>& segments = this->Segments;
    RangeBatch<Real>& ranges = this->Ranges;
    const glm::ivec3 cell = this->CellOf(i);
    const typename Geometry::Segment segment(
      this->Band.Shape.RayOf(this->Rays, this->Owner[i]), cell);
    Corners<Real> corners;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      corners[corner] = segments.Corners[corner][i];
    }
    segments.Enter[i] = segment.Enter();
    ranges.Leave[i] = segment.Leave();
    Cubic<Real> cubic;
    if constexpr (Between == Interpolation::Linear)
    {
      cubic = CubicAlong(corners, segment.Path());
      const std::array<Real, 2> range = RangeOf(cubic);
      ranges.Lowest[i] = range[0];
      ranges.Highest[i] = range[1];
    }
    else
    {
      const NearestPath path = segment.HasLength()
        ? segment.Nearest()
        : NearestPath{ { NearestCorner(segment.Path().Begin) }, {}, 1 };
      const Real begin = corners[path.Corners[0]], end = corners[path.Corners[path.Count - 1]];
      cubic = { begin, begin, end, end };
      ranges.Lowest[i] = ranges.Highest[i] = begin;
      for (std::size_t step = 1; step < path.Count; ++step)
      {
        ranges.Lowest[i] = std::min(ranges.Lowest[i], corners[path.Corners[step]]);
        ranges.Highest[i] = std::max(ranges.Highest[i], corners[path.Corners[step]]);
      }
    }
    for (std::size_t c = 0; c < 4; ++c)
    {
      ranges.Cubic[c][i] = cubic[c];
    }
  }

  /// Update a ray's progress by its measured segment i.
  void TakeNoteOf(std::size_t i, std::size_t ray)
  {
    if (!this->Entered[ray])
    {
      this->EnterBy(i, ray);
    }
    const bool isTouched = !(this->Segments.Enter[i] < this->Ranges.Leave[i]);
    const CellReach<Real>& cell = this->Corner[i];
    const std::array<Real, NumberOfDirections> path = { this->Ranges.Highest[i],
      this->Band.Span - this->Ranges.Lowest[i] };
    for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
    {
      Reach& reached = this->Reached[direction][ray];
      if (reached.IsDone)
      {
        continue;
      }
      const Real corner = cell.Corner[direction];
      this->BringOn(isTouched ? -Cells::Infinity : (cell.IsFinite ? path[direction] : corner),
        corner, cell.Error, reached);
      if (!this->Knots.IsFitted())
      {
        this->NoteCell(direction, i, ray, reached);
      }
      else if (!cell.IsFinite)
      {
        this->Knots.GiveUp(ray);
        reached.IsDone = true;
      }
      else if (!isTouched)
      {
        this->Knots.Follow(direction, ray, this->CubicOf(direction, i), this->Segments.Enter[i],
          this->Ranges.Leave[i]);
      }
    }
  }

  /// A ray begins in segment i. A value that is not finite there differs from isovalue to isovalue.
  void EnterBy(std::size_t i, std::size_t ray)
  {
    this->Enter(ray, this->Ranges.Cubic[0][i], this->Corner[i].Error);
    if (!this->Corner[i].IsFinite)
    {
      this->Knots.GiveUp(ray);
      this->Reached[Rising][ray].IsDone = this->Reached[Falling][ray].IsDone = true;
    }
  }

  /// A ray begins with this difference from the band's lowest isovalue.
  void Enter(std::size_t ray, Real entry, Real error)
  {
    this->Entered[ray] = true;
    if (entry + error >= Real(0))
    {
      this->Entries[ray] = this->Band.Scale.Stored(static_cast<double>(entry));
      this->HasEntries = true;
    }
    this->Reached[Rising][ray].IsDone = entry - error > this->Band.Span;
    this->Reached[Falling][ray].IsDone = this->Band.IsSolid || entry + error < Real(0);
  }

  void BringOn(Real path, Real corner, Real error, Reach& reached) const
  {
    reached.Path = std::max(reached.Path, path);
    reached.Corner = std::max(reached.Corner, corner);
    reached.IsDone = reached.Path + error > this->Band.Span;
  }

  /// Store the cell of segment i as a knot if it raised the ray's progress.
  void NoteCell(std::size_t direction, std::size_t i, std::size_t ray, Reach& reached)
  {
    const double error = static_cast<double>(this->Corner[i].Error);
    const BandScale& scale = this->Band.Scale;
    const BandScale::Key path = scale.KeyOf(static_cast<double>(reached.Path) + error);
    const BandScale::Key corner =
      std::max(path, scale.KeyOf(static_cast<double>(reached.Corner) + error));
    if (path > reached.PathKey || corner > reached.CornerKey)
    {
      // The normal of a ray's first knot is taken half way to where the field comes farthest,
      // others there.
      const bool isFirst = reached.PathKey == 0;
      reached.PathKey = path;
      reached.CornerKey = corner;
      CellIndex cell;
      for (std::size_t a = 0; a < 3; ++a)
      {
        cell[a] = static_cast<std::uint16_t>(this->Segments.Cell[a][i]);
      }
      const double farthest =
        this->Band.Scene.Form.HasNormals ? this->FarthestAt(direction, i) : 0.0;
      const double distance = isFirst ? 0.5 * (this->Segments.Enter[i] + farthest) : farthest;
      this->Knots.AddCell(direction, ray, path, corner, cell, distance);
    }
  }

  /// Progress along segment i, which is rising in its direction.
  Cubic<double> CubicOf(std::size_t direction, std::size_t i) const
  {
    Cubic<double> cubic;
    for (std::size_t c = 0; c < 4; ++c)
    {
      cubic[c] = this->Band.Scale.Progress(
        static_cast<ValueDirection>(direction), static_cast<double>(this->Ranges.Cubic[c][i]));
    }
    return cubic;
  }

  /// Distance of the highest progress in segment i.
  double FarthestAt(std::size_t direction, std::size_t i) const
  {
    const double enter = this->Segments.Enter[i], leave = this->Ranges.Leave[i];
    const Cubic<double> cubic = this->CubicOf(direction, i);
    double farthest = cubic[3] >= cubic[0] ? 1.0 : 0.0;
    if constexpr (Between == Interpolation::Linear)
    {
      int count = 0;
      const std::array<double, 2> turns = TurningPoints(cubic, count);
      double highest = std::max(cubic[0], cubic[3]);
      for (int turn = 0; turn < count; ++turn)
      {
        const double s = turns[static_cast<std::size_t>(turn)];
        if (Evaluate(cubic, s) > highest)
        {
          highest = Evaluate(cubic, s);
          farthest = s;
        }
      }
    }
    return enter + farthest * std::max(leave - enter, 0.0);
  }

  /// Find the values at which rays begin in solids.
  void FindEntries()
  {
    const RayBatch& rays = this->Rays;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.Begin[ray] < rays.End[ray])
      {
        const glm::ivec3 cell =
          this->Band.Shape.RayOf(rays, ray).CellAt(rays.Begin[ray], this->Band.Count);
        const HiddenCells* const hidden = this->Band.Scene.Samples.Hidden.get();
        if (hidden && hidden->IsHidden(cell))
        {
          this->Enter(ray, -Cells::Infinity, Real(0)); // outside, as below the band
          continue;
        }
        Corners<Real> corners;
        const CellReach<Real> reach = this->Band.Read(cell, corners);
        this->Append(ray, cell, corners, reach);
      }
    }
    this->CellsRead += this->Segments.Count;
    this->Measure();
    for (std::size_t i = 0; i < static_cast<std::size_t>(this->Segments.Count); ++i)
    {
      this->EnterBy(i, this->Owner[i]);
    }
    this->Segments.Count = 0;
  }

  const Cells& Band;
  const RayBatch& Rays;
  KnotCollector Knots;

  std::array<std::array<Reach, RayBatch::Capacity>, NumberOfDirections> Reached;
  RayBatch::Array<bool> Entered; ///< the value where the ray begins is known
  RayBatch::Array<float> Entries;
  bool HasEntries = false; ///< some ray begins in the band or above it

  SegmentBatch<Real> Segments; ///< to be measured
  RangeBatch<Real> Ranges;
  RayBatch::Array<CellReach<Real>> Corner; ///< of each segment's cell
  RayBatch::Array<std::size_t> Owner;      ///< ray of each segment
};

}

#endif
