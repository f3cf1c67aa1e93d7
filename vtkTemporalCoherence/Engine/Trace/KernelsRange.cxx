// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/KernelsRange.h"

#include "Trace/CellSegment.h"

#include <algorithm>
#include <cmath>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/KernelsRange.cxx"
#include <hwy/foreach_target.h>

#include "Trace/KernelsSegment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

/// Evaluate of CellRoot.h.
template <class V>
HWY_INLINE V EvaluateAt(const V b[4], V s)
{
  const V q0 = Mix(b[0], b[1], s), q1 = Mix(b[1], b[2], s), q2 = Mix(b[2], b[3], s);
  return Mix(Mix(q0, q1, s), Mix(q1, q2, s), s);
}

/// Widen ranges, in the lanes of `live`, by the values at the turning points of the cubics:
/// TurningPoints of CellRoot.h.
template <class D, class V = hn::Vec<D>, class M = hn::Mask<D>>
HWY_INLINE void WidenByTurns(D d, const V b[4], M live, V& lowest, V& highest)
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1);
  V d0 = hn::Sub(b[1], b[0]), d1 = hn::Sub(b[2], b[1]), d2 = hn::Sub(b[3], b[2]);
  // Scaled by the largest, so that squares neither overflow nor vanish.
  const V largest = hn::Max(hn::Abs(d0), hn::Max(hn::Abs(d1), hn::Abs(d2)));
  const V unit = hn::IfThenElse(hn::Gt(largest, zero), largest, one);
  d0 = hn::Div(d0, unit);
  d1 = hn::Div(d1, unit);
  d2 = hn::Div(d2, unit);
  const V halfB = hn::Sub(d1, d0), a = hn::Sub(hn::Sub(d2, d1), halfB);
  const V discriminant = hn::Sub(hn::Mul(halfB, halfB), hn::Mul(a, d0));
  const M turns = hn::And(live, hn::Gt(discriminant, zero));
  const V root = hn::Sqrt(hn::IfThenElse(turns, discriminant, zero));
  const V q = hn::Neg(hn::Add(halfB, hn::CopySign(root, halfB)));
  const V numerators[2] = { d0, q }, denominators[2] = { q, a };
  for (int i = 0; i < 2; ++i)
  {
    const M isPoint = hn::And(turns, hn::Ne(denominators[i], zero));
    const V s = hn::Div(numerators[i], hn::IfThenElse(isPoint, denominators[i], one));
    const M isWithin = hn::And(isPoint, hn::And(hn::Gt(s, zero), hn::Lt(s, one)));
    const V value = EvaluateAt(b, hn::IfThenElse(isWithin, s, zero));
    lowest = hn::IfThenElse(isWithin, hn::Min(lowest, value), lowest);
    highest = hn::IfThenElse(isWithin, hn::Max(highest, value), highest);
  }
}

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
    V lowest = hn::Min(b[0], b[3]), highest = hn::Max(b[0], b[3]);
    // A cubic lies within the range of its coefficients, so it can leave the range of its ends only
    // if another coefficient does.
    const auto isBeyond =
      hn::Or(hn::Gt(hn::Max(b[1], b[2]), highest), hn::Lt(hn::Min(b[1], b[2]), lowest));
    if (!hn::AllFalse(d, isBeyond))
    {
      WidenByTurns(d, b, isBeyond, lowest, highest);
    }
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
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace
{

template <typename Real>
void FindOneByOne(SegmentBatch<Real>& in, RangeBatch<Real>& out)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.Count); ++i)
  {
    const CellSegment<Real> segment(in, i);
    const Cubic<Real> cubic = CubicAlong(segment.Values, segment.Path);
    in.Enter[i] = segment.Enter;
    out.Leave[i] = segment.Leave;
    const std::array<Real, 2> range = RangeOf(cubic);
    out.Lowest[i] = range[0];
    out.Highest[i] = range[1];
    for (std::size_t c = 0; c < 4; ++c)
    {
      out.Cubic[c][i] = cubic[c];
    }
  }
}

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

HWY_EXPORT(RangesFloat);
HWY_EXPORT(RangesDouble);

void FindRanges(SegmentBatch<float>& segments, RangeBatch<float>& ranges)
{
  if (segments.Count > 0)
  {
    FillLastVector(segments);
    HWY_DYNAMIC_DISPATCH(RangesFloat)(segments, ranges);
  }
}

void FindRanges(SegmentBatch<double>& segments, RangeBatch<double>& ranges)
{
  if (segments.Count > 0)
  {
    FillLastVector(segments);
    HWY_DYNAMIC_DISPATCH(RangesDouble)(segments, ranges);
  }
}

void FindRangesOneByOne(SegmentBatch<float>& segments, RangeBatch<float>& ranges)
{
  FindOneByOne(segments, ranges);
}

void FindRangesOneByOne(SegmentBatch<double>& segments, RangeBatch<double>& ranges)
{
  FindOneByOne(segments, ranges);
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
