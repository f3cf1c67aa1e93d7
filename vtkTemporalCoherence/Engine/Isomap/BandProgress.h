// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandProgress_h
#define TemporalCoherence_BandProgress_h

#include "Isomap/BandCells.h"
#include "Isomap/KnotCollector.h"
#include "Lattice/CellRoot.h"
#include "Lattice/KernelsRange.h"
#include "Lattice/SegmentBatch.h"
#include "Scene/HiddenCells.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Entry, exit and field of segments, as arrays over segments.
template <typename Real>
struct RangesView
{
  const double *Enter, *Leave;
  const Real *Lowest, *Highest;
  std::array<const Real*, 4> Cubic; ///< Bernstein coefficients
};

/// Segments of rays in cells, and the ranges of the field along them, for any geometry
/// (TracedCells.h).
template <typename Geometry, Interpolation Between>
class SegmentRanges
{
public:
  using Real = typename Geometry::Real;

  std::size_t Count() const { return static_cast<std::size_t>(this->Segments.Count); }

  void Clear() { this->Segments.Count = 0; }

  void Append(
    const RayBatch& rays, std::size_t ray, const glm::ivec3& cell, const Corners<Real>& corners)
  {
    this->Owner[this->Count()] = ray;
    AppendSegment(rays, ray, cell, corners, this->Segments);
  }

  void Find(const RayBatch& rays, const Geometry& shape)
  {
    if constexpr (!Geometry::HasKernels)
    {
      for (std::size_t i = 0; i < this->Count(); ++i)
      {
        this->FindOne(rays, shape, i);
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

  RangesView<Real> View() const
  {
    const auto& cubic = this->Ranges.Cubic;
    return { this->Segments.Enter.data(), this->Ranges.Leave.data(), this->Ranges.Lowest.data(),
      this->Ranges.Highest.data(),
      { cubic[0].data(), cubic[1].data(), cubic[2].data(), cubic[3].data() } };
  }

  glm::ivec3 CellOf(std::size_t i) const
  {
    return { this->Segments.Cell[0][i], this->Segments.Cell[1][i], this->Segments.Cell[2][i] };
  }

  RayBatch::Array<std::size_t> Owner; ///< ray of each segment

private:
  /// FindRanges and FindNearestRanges, for one segment.
  void FindOne(const RayBatch& rays, const Geometry& shape, std::size_t i)
  {
    SegmentBatch<Real>& segments = this->Segments;
    RangeBatch<Real>& ranges = this->Ranges;
    const typename Geometry::Segment segment(shape.RayOf(rays, this->Owner[i]), this->CellOf(i));
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

  SegmentBatch<Real> Segments;
  RangeBatch<Real> Ranges;
};

/// The progress of a tile's rays through a band, and the resulting knots.
///
/// The caller takes rays through active cells, and reports each cell that can raise a ray's
/// progress, in order along the ray. Other cells change nothing.
template <typename T, typename Geometry, Interpolation Between>
class BandProgress
{
public:
  using Cells = BandCells<T, Geometry>;
  using Real = typename Geometry::Real;

  BandProgress(const Cells& band, const RayBatch& rays)
    : Band(band)
    , Rays(rays)
    , Knots(rays, band.Scene.Form, band.Scale)
  {
    for (auto& reached : this->Reached)
    {
      reached.fill(-Cells::Infinity);
    }
    this->Entries.fill(-std::numeric_limits<float>::infinity());
    this->HasEntered.fill(false);
    if (band.IsSolid)
    {
      this->FindEntries();
    }
  }

  /// True if nothing ahead of a ray matters.
  bool IsDone(std::size_t ray) const
  {
    return this->Reached[Rising][ray] == Cells::Infinity &&
      this->Reached[Falling][ray] == Cells::Infinity;
  }

  /// True if a cell that reaches this progress can raise the progress of a ray.
  bool CanBringOn(std::size_t ray, Real toRise, Real toFall) const
  {
    return toRise > this->Reached[Rising][ray] || toFall > this->Reached[Falling][ray];
  }

  /// The progress of rays in a direction; infinity where nothing ahead matters.
  const RayBatch::Array<Real>& ReachedIn(std::size_t direction) const
  {
    return this->Reached[direction];
  }

  /// True if the knots exceed the limit.
  bool IsTooLarge() const { return this->Knots.MemoryInBytes() > this->Band.Scene.MemoryLimit; }

  /// Note a cell that a ray passes and that can raise its progress.
  /// \param at, i segments, and the number of the ray's segment in the cell
  void TakeNote(std::size_t ray, const glm::ivec3& place, const CellReach<Real>& cell,
    const RangesView<Real>& at, std::size_t i)
  {
    if (!this->HasEntered[ray])
    {
      this->EnterBy(ray, cell, at.Cubic[0][i]);
    }
    const bool isPassed = at.Enter[i] < at.Leave[i]; // not only missed or touched
    const std::array<Real, NumberOfDirections> along = { at.Highest[i],
      this->Band.Span - at.Lowest[i] };
    for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
    {
      Real& reached = this->Reached[direction][ray];
      if (reached == Cells::Infinity)
      {
        continue;
      }
      const Real path = !isPassed ? -Cells::Infinity
        : cell.IsFinite           ? along[direction]
                                  : cell.Corner[direction];
      const bool isDone = path + cell.Error > this->Band.Span;
      reached = isDone ? Cells::Infinity : std::max(reached, path);
      if (!this->Knots.IsFitted())
      {
        this->NoteCell(direction, ray, place, this->Band.KeyOf(path, cell), at, i);
      }
      else if (!cell.IsFinite)
      {
        this->Knots.GiveUp(ray);
        reached = Cells::Infinity;
      }
      else if (isPassed)
      {
        this->Knots.Follow(
          direction, ray, this->CubicOf(direction, at, i), at.Enter[i], at.Leave[i]);
      }
    }
  }

  /// Hand the knots over. This object is unusable afterwards.
  /// \throws std::bad_alloc
  void HandOver(TileKnots& knots)
  {
    const BandScene& scene = this->Band.Scene;
    this->Knots.HandOver(
      { scene.Samples, scene.Normals, scene.FiniteRange, scene.Transform }, knots);
    if (this->HasEntries)
    {
      knots.Entries.assign(this->Entries.begin(), this->Entries.begin() + this->Rays.Count);
    }
  }

  std::int64_t CellsRead = 0;

private:
  /// Begin a ray in a cell. Non-finite samples there make the ray unresolved, as their differences
  /// depend on the isovalue.
  void EnterBy(std::size_t ray, const CellReach<Real>& cell, Real entry)
  {
    this->Enter(ray, entry, cell.Error);
    if (!cell.IsFinite)
    {
      this->Knots.GiveUp(ray);
      this->Reached[Rising][ray] = this->Reached[Falling][ray] = Cells::Infinity;
    }
  }

  /// Begin a ray at a difference from the band's lowest isovalue.
  void Enter(std::size_t ray, Real entry, Real error)
  {
    this->HasEntered[ray] = true;
    if (entry + error >= Real(0))
    {
      this->Entries[ray] = this->Band.Scale.Stored(static_cast<double>(entry));
      this->HasEntries = true;
    }
    if (entry - error > this->Band.Span)
    {
      this->Reached[Rising][ray] = Cells::Infinity;
    }
    if (this->Band.IsSolid || entry + error < Real(0))
    {
      this->Reached[Falling][ray] = Cells::Infinity;
    }
  }

  /// Store a cell as a knot if it raised the ray's progress.
  void NoteCell(std::size_t direction, std::size_t ray, const glm::ivec3& place,
    BandScale::Key reached, const RangesView<Real>& at, std::size_t i)
  {
    BandScale::Key& last = this->Noted[direction][ray];
    if (reached > last)
    {
      // Normals are taken at the farthest progress; a ray's first normal half way to that point.
      const bool isFirst = last == 0;
      last = reached;
      const CellIndex index = { static_cast<std::uint16_t>(place.x),
        static_cast<std::uint16_t>(place.y), static_cast<std::uint16_t>(place.z) };
      const double farthest =
        this->Band.Scene.Form.HasNormals ? this->FarthestAt(direction, at, i) : 0.0;
      const double distance = isFirst ? 0.5 * (at.Enter[i] + farthest) : farthest;
      this->Knots.AddCell(direction, ray, reached, index, distance);
    }
  }

  /// Progress along segment i as a cubic, in one direction.
  Cubic<double> CubicOf(std::size_t direction, const RangesView<Real>& at, std::size_t i) const
  {
    Cubic<double> cubic;
    for (std::size_t c = 0; c < 4; ++c)
    {
      cubic[c] = this->Band.Scale.Progress(
        static_cast<ValueDirection>(direction), static_cast<double>(at.Cubic[c][i]));
    }
    return cubic;
  }

  /// Distance of the highest progress in segment i.
  double FarthestAt(std::size_t direction, const RangesView<Real>& at, std::size_t i) const
  {
    const Cubic<double> cubic = this->CubicOf(direction, at, i);
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
    return at.Enter[i] + farthest * std::max(at.Leave[i] - at.Enter[i], 0.0);
  }

  /// Find the values at which rays begin in solids.
  void FindEntries()
  {
    const RayBatch& rays = this->Rays;
    SegmentRanges<Geometry, Between> segments;
    RayBatch::Array<CellReach<Real>> cells;
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
        cells[segments.Count()] = this->Band.Read(cell, corners);
        segments.Append(rays, ray, cell, corners);
      }
    }
    this->CellsRead += static_cast<std::int64_t>(segments.Count());
    segments.Find(rays, this->Band.Shape);
    for (std::size_t i = 0; i < segments.Count(); ++i)
    {
      this->EnterBy(segments.Owner[i], cells[i], segments.View().Cubic[0][i]);
    }
  }

  const Cells& Band;
  const RayBatch& Rays;
  KnotCollector Knots;

  alignas(64) std::array<RayBatch::Array<Real>, NumberOfDirections> Reached;
  std::array<RayBatch::Array<BandScale::Key>, NumberOfDirections> Noted{}; ///< last knots' keys
  RayBatch::Array<bool> HasEntered; ///< the value where the ray begins is known
  RayBatch::Array<float> Entries;
  bool HasEntries = false; ///< some ray begins in the band or above it
};

}

#endif
