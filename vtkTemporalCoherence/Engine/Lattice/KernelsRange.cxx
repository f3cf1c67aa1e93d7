// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsRange.h"

#include "Lattice/CellSegment.h"

#include <algorithm>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsRange.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsRange-inl.h"
#include "Lattice/KernelsSegment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace SegmentKernels
{
namespace HWY_NAMESPACE
{

template <typename Real>
HWY_INLINE void FindAll(SegmentBatch<Real>& segments, RangeBatch<Real>& ranges)
{
  const std::size_t count = FullVectors(segments);
  Paths<Real> paths;
  SetUpPaths(segments, count, paths);
  std::copy_n(paths.Leave.begin(), count, ranges.Leave.begin());

  const hn::CappedTag<Real, WidestVector> d;
  using V = hn::Vec<decltype(d)>;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    V b[4];
    CubicsAlong(d, segments, paths, i, b);
    V lowest, highest;
    RangesOf(d, b, lowest, highest);
    for (std::size_t c = 0; c < 4; ++c)
    {
      hn::StoreU(b[c], d, &ranges.Cubic[c][i]);
    }
    hn::StoreU(lowest, d, &ranges.Lowest[i]);
    hn::StoreU(highest, d, &ranges.Highest[i]);
  }
}

void RangesFloat(SegmentBatch<float>& segments, RangeBatch<float>& ranges)
{
  FindAll(segments, ranges);
}

void RangesDouble(SegmentBatch<double>& segments, RangeBatch<double>& ranges)
{
  FindAll(segments, ranges);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace
{

template <typename Real>
void FindNearest(SegmentBatch<Real>& in, RangeBatch<Real>& out)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.Count); ++i)
  {
    const CellSegment<Real> segment(in, i);
    in.Enter[i] = segment.Enter;
    out.Leave[i] = segment.Leave;
    const bool passes = segment.Enter < segment.Leave;
    const NearestPath path =
      passes ? segment.Nearest(in, i) : NearestPath{ { NearestCorner(segment.Path.Begin) }, {}, 1 };
    out.Cubic[0][i] = segment.Values[path.Corners[0]];
    out.Cubic[3][i] = segment.Values[path.Corners[path.Count - 1]];
    out.Cubic[1][i] = out.Cubic[0][i];
    out.Cubic[2][i] = out.Cubic[3][i];
    out.Lowest[i] = out.Highest[i] = out.Cubic[0][i];
    for (std::size_t step = 1; step < path.Count; ++step)
    {
      out.Lowest[i] = std::min(out.Lowest[i], segment.Values[path.Corners[step]]);
      out.Highest[i] = std::max(out.Highest[i], segment.Values[path.Corners[step]]);
    }
  }
}

}

namespace SegmentKernels
{
HWY_EXPORT(RangesFloat);
HWY_EXPORT(RangesDouble);
}

void FindRanges(SegmentBatch<float>& segments, RangeBatch<float>& ranges)
{
  using namespace SegmentKernels;
  if (segments.Count > 0)
  {
    FillLastVector(segments);
    HWY_DYNAMIC_DISPATCH(RangesFloat)(segments, ranges);
  }
}

void FindRanges(SegmentBatch<double>& segments, RangeBatch<double>& ranges)
{
  using namespace SegmentKernels;
  if (segments.Count > 0)
  {
    FillLastVector(segments);
    HWY_DYNAMIC_DISPATCH(RangesDouble)(segments, ranges);
  }
}

void FindNearestRanges(SegmentBatch<float>& segments, RangeBatch<float>& ranges)
{
  FindNearest(segments, ranges);
}

void FindNearestRanges(SegmentBatch<double>& segments, RangeBatch<double>& ranges)
{
  FindNearest(segments, ranges);
}

}
#endif
