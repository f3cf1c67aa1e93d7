// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SegmentRanges_h
#define TemporalCoherence_SegmentRanges_h

#include "Lattice/CellRoot.h"
#include "Lattice/KernelsRange.h"
#include "Lattice/SegmentBatch.h"

#include <algorithm>
#include <array>

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

}

#endif
