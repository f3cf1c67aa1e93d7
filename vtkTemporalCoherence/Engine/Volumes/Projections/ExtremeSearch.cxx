// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/ExtremeSearch.h"

#include "Lattice/CellRoot.h"
#include "Lattice/CellSamples.h"
#include "Lattice/CellWalk.h"
#include "Lattice/RectilinearCells.h"
#include "Lattice/UniformCells.h"
#include "Scene/HiddenCells.h"
#include "Volumes/Projections/ExtremeBlocks.h"
#include "Volumes/Projections/KernelsExtremes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// The largest value on a segment of a ray, and the first share of the segment with this value.
template <typename Real>
struct SegmentExtreme
{
  void Widen(Real value, double share)
  {
    if (value > this->Value)
    {
      this->Value = value;
      this->Share = share;
    }
  }

  Real Value;
  double Share = 0.0;
};

/// The largest value of a cubic on [0, 1].
template <typename Real>
SegmentExtreme<Real> LargestOf(const Cubic<Real>& b)
{
  SegmentExtreme<Real> largest{ b[0] };
  const Real most = std::max(b[1], b[2]);
  if (most > std::max(b[0], b[3]))
  {
    int count = 0;
    const std::array<Real, 2> turns = TurningPoints(b, count);
    for (int turn = 0; turn < count; ++turn)
    {
      const Real share = turns[static_cast<std::size_t>(turn)];
      largest.Widen(std::min(Evaluate(b, share), most), static_cast<double>(share));
    }
  }
  largest.Widen(b[3], 1.0);
  return largest;
}

/// Finds extremes ray by ray, from cell to cell, for any geometry of cells (TracedCells.h). A
/// minimum is found as the maximum of the negated samples.
template <typename T, typename Geometry, Interpolation Between>
class ExtremeWalk final
  : public ExtremeSearch
  , public CellMeeting<typename Geometry::Real>
{
public:
  using Real = typename Geometry::Real;
  using Segment = typename Geometry::Segment;

  ExtremeWalk(const ExtremeTask& task, const Geometry& shape)
    : Samples(task.Samples)
    , Shape(shape)
    , Count(task.Samples.Dimensions - 1)
    , Hidden(task.Samples.Hidden.get())
    , Sign(task.IsMinimum ? Real(-1) : Real(1))
  {
  }

  void Search(const RayBatch& rays, const RayExtremes& found) const override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.Begin[ray] < rays.End[ray])
      {
        this->Walk(rays, ray, found);
      }
    }
  }

  bool Meet(const RayBatch& rays, std::size_t ray, const ExtremeCell<Real>& cell, Real& value,
    double& at) const override
  {
    const Segment segment(this->Shape.RayOf(rays, ray), cell.Place);
    return MeetIn(segment, cell.Samples, value, at);
  }

private:
  void Walk(const RayBatch& rays, std::size_t ray, const RayExtremes& found) const
  {
    const auto line = this->Shape.RayOf(rays, ray);
    CellWalk walk;
    walk.Begin(line, this->Count);
    while (walk.FindAny(line, this->Count))
    {
      Corners<Real> corners;
      if (!(this->Hidden && this->Hidden->IsHidden(walk.Here())) &&
        this->Read(walk.Here(), corners))
      {
        ++found.CellsRead;
        this->SearchCell(Segment(line, walk.Here()), corners, ray, found);
      }
    }
  }

  /// \return false if a sample is not finite
  bool Read(const glm::ivec3& cell, Corners<Real>& corners) const
  {
    const std::array<T, 8> samples = this->Samples.Read(cell);
    bool areFinite = true;
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = this->Sign * static_cast<Real>(samples[i]);
      areFinite &= std::isfinite(corners[i]);
    }
    return areFinite;
  }

  void SearchCell(const Segment& segment, const Corners<Real>& corners, std::size_t ray,
    const RayExtremes& found) const
  {
    Real largest;
    double at;
    if (!MeetIn(segment, corners, largest, at))
    {
      return;
    }
    const double value = static_cast<double>(this->Sign * largest);
    const double before = found.Value[ray];
    const bool isBeyond = this->Sign > Real(0) ? value > before : value < before;
    if (std::isnan(before) || isBeyond || (value == before && at < found.First[ray]))
    {
      found.Value[ray] = value;
      found.First[ray] = at;
    }
  }

  /// \return false if the ray only touches the cell
  static bool MeetIn(const Segment& segment, const Corners<Real>& corners, Real& value, double& at)
  {
    if (!segment.HasLength())
    {
      return false;
    }
    // Clamp rounding errors to the range of the corners. Between equal samples they would move the
    // first place of the largest value.
    const auto ends = std::minmax_element(corners.begin(), corners.end());
    const SegmentExtreme<Real> largest = LargestIn(segment, corners, *ends.first, *ends.second);
    value = std::min(std::max(largest.Value, *ends.first), *ends.second);
    at = segment.DistanceAt(largest.Share);
    return true;
  }

  static SegmentExtreme<Real> LargestIn(
    const Segment& segment, const Corners<Real>& corners, Real low, Real high)
  {
    if constexpr (Between == Interpolation::Linear)
    {
      Cubic<Real> b = CubicAlong(corners, segment.Path());
      for (Real& coefficient : b)
      {
        coefficient = std::min(std::max(coefficient, low), high);
      }
      return LargestOf(b);
    }
    else
    {
      const NearestPath path = segment.Nearest();
      SegmentExtreme<Real> largest{ corners[path.Corners[0]] };
      for (std::size_t step = 1; step < path.Count; ++step)
      {
        largest.Widen(corners[path.Corners[step]], path.Shares[step]);
      }
      return largest;
    }
  }

  CellSamples<T> Samples;
  Geometry Shape;
  glm::ivec3 Count; ///< of cells along each axis
  const HiddenCells* Hidden;
  Real Sign;
};

/// Finds extremes tile by tile. Rays that run the same way along each axis form a beam, which goes
/// from block to block. Other rays walk.
/// \tparam Real number type of the geometry of cells
template <typename T, typename Real>
class ExtremeBeams final : public ExtremeSearch
{
public:
  /// \param walk    for rays that cannot form a beam
  /// \param meeting this walk for nearest interpolation; else null
  ExtremeBeams(const ExtremeTask& task, std::unique_ptr<const ExtremeSearch> walk,
    const CellMeeting<Real>* meeting)
    : Blocks(task.Samples, task.Ranges ? *task.Ranges : this->Build(task.Samples), task.IsMinimum)
    , Meeting(meeting)
    , Grid(task.Grid)
    , Least(RoundedDown(task.IsMinimum ? -task.LeastSeen : task.LeastSeen))
    , Sign(task.IsMinimum ? -1.0 : 1.0)
    , Walk(std::move(walk))
  {
  }

  void Search(const RayBatch& rays, const RayExtremes& found) const override
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    BeamExtremes<Real> largest;
    for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
    {
      const double value = found.Value[i];
      largest.Value[i] = static_cast<Real>(std::isnan(value) ? -infinity : this->Sign * value);
      largest.First[i] = found.First[i];
    }
    const BeamSearch<Real> search{ this->Blocks, this->Meeting, this->Grid, this->Least };
    std::uint64_t walking = 0;
    for (const std::uint64_t which : Alike(rays))
    {
      const bool isDone = which == 0 || FindExtremes(search, rays, which, largest);
      walking |= isDone ? 0 : which;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      if (largest.First[i] < infinity)
      {
        found.Value[i] = this->Sign * static_cast<double>(largest.Value[i]);
        found.First[i] = largest.First[i];
      }
    }
    found.CellsRead += largest.CellsRead;
    if (walking != 0)
    {
      this->LetWalk(rays, walking, found);
    }
  }

private:
  const ValueRangePyramid& Build(const Field& samples)
  {
    this->Own.Build(samples);
    return this->Own;
  }

  /// The rays, one bit each, by the octant of their direction.
  static std::array<std::uint64_t, 8> Alike(const RayBatch& rays)
  {
    std::array<std::uint64_t, 8> alike{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      const std::size_t way = static_cast<std::size_t>(rays.Direction[0][i] > 0.0) |
        static_cast<std::size_t>(rays.Direction[1][i] > 0.0) << 1 |
        static_cast<std::size_t>(rays.Direction[2][i] > 0.0) << 2;
      alike[way] |= static_cast<std::uint64_t>(rays.HasWalk(i)) << i;
    }
    return alike;
  }

  void LetWalk(const RayBatch& rays, std::uint64_t which, const RayExtremes& found) const
  {
    RayBatch walking = rays;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      walking.End[i] = which >> i & 1u ? walking.End[i] : walking.Begin[i];
    }
    this->Walk->Search(walking, found);
  }

  ValueRangePyramid Own; ///< if the task gives no ranges
  TypedExtremeBlocks<T, Real> Blocks;
  const CellMeeting<Real>* Meeting;
  const GridCoordinates* Grid;
  float Least; ///< smallest visible value
  double Sign;
  std::unique_ptr<const ExtremeSearch> Walk;
};

template <typename T, typename Geometry>
std::unique_ptr<const ExtremeSearch> MakeSearch(const ExtremeTask& task, const Geometry& shape)
{
  using Beams = ExtremeBeams<T, typename Geometry::Real>;
  using Search = std::unique_ptr<const ExtremeSearch>;
  if (task.Samples.Between == Interpolation::Nearest)
  {
    auto walk = std::make_unique<ExtremeWalk<T, Geometry, Interpolation::Nearest>>(task, shape);
    const CellMeeting<typename Geometry::Real>* const meeting = walk.get();
    return task.ByBeams ? Search(std::make_unique<Beams>(task, std::move(walk), meeting))
                        : Search(std::move(walk));
  }
  auto walk = std::make_unique<ExtremeWalk<T, Geometry, Interpolation::Linear>>(task, shape);
  return task.ByBeams ? Search(std::make_unique<Beams>(task, std::move(walk), nullptr))
                      : Search(std::move(walk));
}

}

std::unique_ptr<const ExtremeSearch> MakeExtremeSearch(const ExtremeTask& task)
{
  return DispatchScalarType(task.Samples.Type,
    [&](auto type)
    {
      using T = decltype(type);
      return task.Grid ? MakeSearch<T>(task, RectilinearCells<T>(*task.Grid))
                       : MakeSearch<T>(task, UniformCells<T>());
    });
}

}
