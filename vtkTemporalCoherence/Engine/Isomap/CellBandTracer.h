// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellBandTracer_h
#define TemporalCoherence_CellBandTracer_h

#include "Acceleration/HiddenCells.h"
#include "Isomap/BandTracer.h"
#include "Scene/Difference.h"
#include "Trace/CellRoot.h"
#include "Trace/CellSamples.h"
#include "Trace/CellWalk.h"
#include "Trace/KernelsRange.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace TemporalCoherence
{

/// The BandTracer of fields with samples at the corners of cells, for any geometry of cells
/// (TracedCells.h).
template <typename T, typename Geometry, Interpolation Between>
class CellBandTracer final : public BandTracer
{
public:
  using Real = typename Geometry::Real;
  using Value = typename Geometry::Value;

  CellBandTracer(const BandScene& scene, const Geometry& shape)
    : Scene(scene)
    , Shape(shape)
    , Samples(scene.Samples)
    , Scale(scene.Samples.Type, scene.Band, scene.FiniteRange)
    , FromLowest(scene.Band.Low, scene.FiniteRange, Scale.Isovalues)
    , Span(static_cast<Real>(this->Scale.Span))
    , Cells(scene.Samples.Dimensions - 1)
    , IsSolid(scene.Mode == SurfaceMode::Threshold)
  {
  }

  std::int64_t Trace(const RayBatch& rays, TileKnots& knots) const override
  {
    Progress progress(rays, this->Scene.Form, this->Scale);
    if (this->IsSolid)
    {
      this->FindEntries(progress);
    }
    progress.Live.Begin(
      rays, this->Shape, this->Cells, [&](std::size_t ray) { return !progress.IsDone(ray); });
    while (progress.Live.Count > 0 && progress.Knots.MemoryInBytes() <= this->Scene.MemoryLimit)
    {
      // Walk to the next cells that can raise the rays' progress.
      progress.Live.Keep([&](std::size_t ray) { return this->Advance(ray, progress); });
      this->Measure(progress);
      this->TakeNote(progress);
      progress.Live.Keep([&](std::size_t ray) { return !progress.IsDone(ray); });
    }
    progress.Knots.HandOver(
      this->Scene.Samples, this->Scene.FiniteRange, this->Scene.Transform, knots);
    if (progress.HasEntries)
    {
      knots.Entries.assign(progress.Entries.begin(), progress.Entries.begin() + rays.Count);
    }
    return progress.CellsRead;
  }

private:
  static constexpr Real Infinity = std::numeric_limits<Real>::infinity();
  static constexpr std::size_t Rising = 0, Falling = 1;

  /// Progress of a ray through the band in one direction.
  struct Reach
  {
    Real Path = -Infinity;   ///< progress of the field along the ray
    Real Corner = -Infinity; ///< progress of the samples around it
    BandScale::Key PathKey = 0, CornerKey = 0;
    bool IsDone = false;
  };

  /// A cell: the progress of its samples in both directions.
  struct CellReach
  {
    std::array<Real, NumberOfDirections> Corner;
    Real Error;    ///< rounding error between two ways to compute a value of the field
    bool IsFinite; ///< all samples are finite
  };

  /// The state of the rays of a tile.
  struct Progress
  {
    Progress(const RayBatch& rays, const KnotForm& form, const BandScale& scale)
      : Rays(rays)
      , Knots(rays, form, scale)
    {
      this->Entries.fill(-std::numeric_limits<float>::infinity());
      this->HasEntered.fill(false);
    }

    bool IsDone(std::size_t ray) const
    {
      return this->Reached[Rising][ray].IsDone && this->Reached[Falling][ray].IsDone;
    }

    const RayBatch& Rays;
    LiveRays Live;

    std::array<std::array<Reach, RayBatch::Capacity>, NumberOfDirections> Reached;
    RayBatch::Array<bool> HasEntered; ///< the value where the ray begins is known
    RayBatch::Array<float> Entries;
    bool HasEntries = false; ///< some ray begins in the band or above it

    SegmentBatch<Real> Segments; ///< cell segments to be measured
    RangeBatch<Real> Ranges;
    std::array<CellReach, RayBatch::Capacity> Corners; ///< of each segment
    std::array<std::size_t, RayBatch::Capacity> Owner; ///< ray of each segment

    KnotCollector Knots;
    std::int64_t CellsRead = 0;
  };

  /// The ranges of samples that can raise a ray's progress.
  struct UsefulRanges
  {
    bool CanBringOn(Real toRise, Real toFall) const
    {
      return (!this->Rises.IsDone && toRise > this->Rises.Path) ||
        (!this->Falls.IsDone && toFall > this->Falls.Path);
    }
    bool IsOfUse(const ValueRangePyramid::Range<T>& range) const
    {
      Real highest = this->Tracer.FromLowest(static_cast<Value>(range.Max));
      Real lowest = this->Tracer.FromLowest(static_cast<Value>(range.Min));
      if constexpr (std::is_floating_point_v<T>)
      {
        // As for cells: samples that are not finite may have any progress.
        highest = std::isfinite(range.Max) ? highest : Infinity;
        lowest = std::isfinite(range.Min) ? lowest : -Infinity;
      }
      return this->CanBringOn(highest, this->Tracer.Span - lowest);
    }
    bool IsNodeOfUse(std::int64_t node) const
    {
      return this->IsOfUse(this->Tracer.Scene.Pyramid->template NodeAt<T>(node));
    }
    bool IsLeafOfUse(std::int64_t node, int leaf) const
    {
      return this->IsOfUse(this->Tracer.Scene.Pyramid->template LeavesOf<T>(node)[leaf]);
    }

    const CellBandTracer& Tracer;
    const Reach &Rises, &Falls;
  };

  /// Walk to the next cell that can raise a ray's progress.
  /// \return false if its walk ends first
  bool Advance(std::size_t ray, Progress& progress) const
  {
    const UsefulRanges useful{ *this, progress.Reached[Rising][ray],
      progress.Reached[Falling][ray] };
    CellWalk& walk = progress.Live.Walks[ray];
    const auto line = this->Shape.RayOf(progress.Rays, ray);
    while (walk.FindActive(line, *this->Scene.Active, this->Samples.All(), useful))
    {
      Corners<Real> corners;
      const CellReach reach = this->Read(walk.Here(), corners);
      ++progress.CellsRead;
      if (useful.CanBringOn(reach.Corner[Rising], reach.Corner[Falling]))
      {
        this->Append(ray, walk.Here(), corners, reach, progress);
        return true;
      }
    }
    return false;
  }

  CellReach Read(const glm::ivec3& cell, Corners<Real>& corners) const
  {
    const std::array<T, 8> samples = this->Samples.Read(cell);
    CellReach reach{ {}, Real(0), true };
    Real lowest = Infinity, highest = -Infinity;
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = this->FromLowest(static_cast<Value>(samples[i]));
      lowest = std::min(lowest, corners[i]);
      highest = std::max(highest, corners[i]);
    }
    constexpr Real rounding = 16 * std::numeric_limits<Real>::epsilon();
    reach.Error = rounding * (std::max(std::abs(lowest), std::abs(highest)) + this->Span);
    if constexpr (std::is_floating_point_v<T>)
    {
      for (const T sample : samples)
      {
        if (!std::isfinite(sample))
        {
          // The difference of such a sample depends on the isovalue, so it may have any progress.
          reach.IsFinite = false;
          (sample > T(0) ? highest : lowest) = sample > T(0) ? Infinity : -Infinity;
        }
      }
    }
    reach.Corner = { highest, this->Span - lowest };
    return reach;
  }

  void Append(std::size_t ray, const glm::ivec3& cell, const Corners<Real>& corners,
    const CellReach& reach, Progress& progress) const
  {
    const auto at = static_cast<std::size_t>(progress.Segments.Count);
    AppendSegment(progress.Rays, ray, cell, corners, progress.Segments);
    progress.Owner[at] = ray;
    progress.Corners[at] = reach;
  }

  void Measure(Progress& progress) const
  {
    if constexpr (!Geometry::HasKernels)
    {
      for (std::size_t i = 0; i < static_cast<std::size_t>(progress.Segments.Count); ++i)
      {
        this->MeasureOne(i, progress);
      }
    }
    else if constexpr (Between == Interpolation::Linear)
    {
      FindRanges(progress.Segments, progress.Ranges);
    }
    else
    {
      FindNearestRanges(progress.Segments, progress.Ranges);
    }
  }

  /// FindRanges and FindNearestRanges, for one segment.
  void MeasureOne(std::size_t i, Progress& progress) const
  {
    SegmentBatch<Real>& segments = progress.Segments;
    RangeBatch<Real>& ranges = progress.Ranges;
    const glm::ivec3 cell(segments.Cell[0][i], segments.Cell[1][i], segments.Cell[2][i]);
    const typename Geometry::Segment segment(
      this->Shape.RayOf(progress.Rays, progress.Owner[i]), cell);
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

  /// Update the rays' progress by their measured segments.
  void TakeNote(Progress& progress) const
  {
    for (std::size_t i = 0; i < static_cast<std::size_t>(progress.Segments.Count); ++i)
    {
      const std::size_t ray = progress.Owner[i];
      if (!progress.HasEntered[ray])
      {
        this->EnterBy(i, ray, progress);
      }
      const bool isTouched = !(progress.Segments.Enter[i] < progress.Ranges.Leave[i]);
      const CellReach& cell = progress.Corners[i];
      const std::array<Real, NumberOfDirections> path = { progress.Ranges.Highest[i],
        this->Span - progress.Ranges.Lowest[i] };
      for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
      {
        Reach& reached = progress.Reached[direction][ray];
        if (reached.IsDone)
        {
          continue;
        }
        const Real corner = cell.Corner[direction];
        this->BringOn(isTouched ? -Infinity : (cell.IsFinite ? path[direction] : corner), corner,
          cell.Error, reached);
        if (!progress.Knots.IsFitted())
        {
          this->NoteCell(direction, i, ray, reached, progress);
        }
        else if (!cell.IsFinite)
        {
          progress.Knots.GiveUp(ray);
          reached.IsDone = true;
        }
        else if (!isTouched)
        {
          progress.Knots.Follow(direction, ray, this->CubicOf(direction, i, progress),
            progress.Segments.Enter[i], progress.Ranges.Leave[i]);
        }
      }
    }
    progress.Segments.Count = 0;
  }

  /// A ray begins in segment i. A value that is not finite there differs from isovalue to isovalue.
  void EnterBy(std::size_t i, std::size_t ray, Progress& progress) const
  {
    this->Enter(ray, progress.Ranges.Cubic[0][i], progress.Corners[i].Error, progress);
    if (!progress.Corners[i].IsFinite)
    {
      progress.Knots.GiveUp(ray);
      progress.Reached[Rising][ray].IsDone = progress.Reached[Falling][ray].IsDone = true;
    }
  }

  /// A ray begins with this difference from the band's lowest isovalue.
  void Enter(std::size_t ray, Real entry, Real error, Progress& progress) const
  {
    progress.HasEntered[ray] = true;
    if (entry + error >= Real(0))
    {
      progress.Entries[ray] = this->Scale.Stored(static_cast<double>(entry));
      progress.HasEntries = true;
    }
    progress.Reached[Rising][ray].IsDone = entry - error > this->Span;
    progress.Reached[Falling][ray].IsDone = this->IsSolid || entry + error < Real(0);
  }

  void BringOn(Real path, Real corner, Real error, Reach& reached) const
  {
    reached.Path = std::max(reached.Path, path);
    reached.Corner = std::max(reached.Corner, corner);
    reached.IsDone = reached.Path + error > this->Span;
  }

  /// Store the cell of segment i as a knot if it raised the ray's progress.
  void NoteCell(
    std::size_t direction, std::size_t i, std::size_t ray, Reach& reached, Progress& progress) const
  {
    const double error = static_cast<double>(progress.Corners[i].Error);
    const BandScale::Key path = this->Scale.KeyOf(static_cast<double>(reached.Path) + error);
    const BandScale::Key corner =
      std::max(path, this->Scale.KeyOf(static_cast<double>(reached.Corner) + error));
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
        cell[a] = static_cast<std::uint16_t>(progress.Segments.Cell[a][i]);
      }
      const double farthest =
        this->Scene.Form.HasNormals ? this->FarthestAt(direction, i, progress) : 0.0;
      const double distance = isFirst ? 0.5 * (progress.Segments.Enter[i] + farthest) : farthest;
      progress.Knots.AddCell(direction, ray, path, corner, cell, distance);
    }
  }

  /// Progress along segment i, which is rising in its direction.
  Cubic<double> CubicOf(std::size_t direction, std::size_t i, const Progress& progress) const
  {
    Cubic<double> cubic;
    for (std::size_t c = 0; c < 4; ++c)
    {
      cubic[c] = this->Scale.Progress(
        static_cast<ValueDirection>(direction), static_cast<double>(progress.Ranges.Cubic[c][i]));
    }
    return cubic;
  }

  /// Distance of the highest progress in segment i.
  double FarthestAt(std::size_t direction, std::size_t i, const Progress& progress) const
  {
    const double enter = progress.Segments.Enter[i], leave = progress.Ranges.Leave[i];
    const Cubic<double> cubic = this->CubicOf(direction, i, progress);
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
  void FindEntries(Progress& progress) const
  {
    const RayBatch& rays = progress.Rays;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.Begin[ray] < rays.End[ray])
      {
        const glm::ivec3 cell = this->Shape.RayOf(rays, ray).CellAt(rays.Begin[ray], this->Cells);
        if (this->Scene.Samples.Hidden && this->Scene.Samples.Hidden->IsHidden(cell))
        {
          this->Enter(ray, -Infinity, Real(0), progress); // outside, as below the band
          continue;
        }
        Corners<Real> corners;
        const CellReach reach = this->Read(cell, corners);
        this->Append(ray, cell, corners, reach, progress);
      }
    }
    progress.CellsRead += progress.Segments.Count;
    this->Measure(progress);
    for (std::size_t i = 0; i < static_cast<std::size_t>(progress.Segments.Count); ++i)
    {
      this->EnterBy(i, progress.Owner[i], progress);
    }
    progress.Segments.Count = 0;
  }

  BandScene Scene;
  Geometry Shape;
  CellSamples<T> Samples;
  BandScale Scale;
  Difference<Value> FromLowest;
  Real Span;
  glm::ivec3 Cells; ///< number of cells along each axis
  bool IsSolid;
};

/// Make the tracer of a scene for a geometry.
template <typename T, typename Geometry>
std::shared_ptr<const BandTracer> MakeCellBandTracer(const BandScene& scene, const Geometry& shape)
{
  if (scene.Samples.Between == Interpolation::Nearest)
  {
    return std::make_shared<CellBandTracer<T, Geometry, Interpolation::Nearest>>(scene, shape);
  }
  return std::make_shared<CellBandTracer<T, Geometry, Interpolation::Linear>>(scene, shape);
}

}

#endif
