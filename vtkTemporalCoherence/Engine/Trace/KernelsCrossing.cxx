// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/KernelsCrossing.h"

#include "Trace/CellRoot.h"
#include "Trace/CellSegment.h"

#include <algorithm>
#include <limits>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/KernelsCrossing.cxx"
#include <hwy/foreach_target.h>

#include "Trace/KernelsSegment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace SegmentKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// RefineCrossing of CellRoot.h on [0, 1], for the lanes in `live`.
template <typename Real, class D, class V = hn::Vec<D>, class M = hn::Mask<D>>
HWY_INLINE V RefineCrossings(D d, const V b[4], M live)
{
  constexpr int MostSteps = 32;
  const V tolerance = hn::Set(d, sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12));
  const V zero = hn::Zero(d), one = hn::Set(d, Real(1)), two = hn::Set(d, Real(2));
  const V three = hn::Set(d, Real(3)), half = hn::Set(d, Real(0.5));

  const V step01 = hn::Sub(b[1], b[0]), step12 = hn::Sub(b[2], b[1]);
  const V c0 = b[0];
  const V c1 = hn::Mul(three, step01);
  const V c2 = hn::Mul(three, hn::Sub(step12, step01));
  const V c3 = hn::Sub(hn::Sub(b[3], b[0]), hn::Mul(three, step12));
  const V slope3 = hn::Mul(three, c3), slope2 = hn::Mul(two, c2);

  const M insideLow = hn::Ge(b[0], zero);
  const M differs = hn::Ne(b[3], b[0]);
  const V span = hn::IfThenElse(differs, hn::Sub(b[0], b[3]), one);
  const V chord = hn::IfThenElse(differs, hn::Div(b[0], span), half);
  V low = zero, high = one;
  V s = hn::Min(hn::Max(chord, hn::Set(d, Real(0.0625))), hn::Set(d, Real(0.9375)));
  for (int step = 0; step < MostSteps && !hn::AllFalse(d, live); ++step)
  {
    const V value = hn::Add(hn::Mul(hn::Add(hn::Mul(hn::Add(hn::Mul(c3, s), c2), s), c1), s), c0);
    const V slope = hn::Add(hn::Mul(hn::Add(hn::Mul(slope3, s), slope2), s), c1);
    const M isLow = hn::Not(hn::Xor(hn::Ge(value, zero), insideLow));
    low = hn::IfThenElse(isLow, s, low);
    high = hn::IfThenElse(isLow, high, s);
    const M isFlat = hn::Eq(slope, zero);
    const V newton = hn::Div(hn::Neg(value), hn::IfThenElse(isFlat, one, slope));
    const V distance = hn::IfThenElse(isFlat, two, newton);
    V next = hn::Add(s, distance);
    const M isOut = hn::Not(hn::And(hn::Gt(next, low), hn::Lt(next, high)));
    const M isDone = hn::And(
      isOut, hn::Or(hn::Le(hn::Abs(distance), tolerance), hn::Le(hn::Sub(high, low), tolerance)));
    live = hn::AndNot(isDone, live);
    next = hn::IfThenElse(isOut, hn::Mul(half, hn::Add(low, high)), next);
    const V moved = hn::Abs(hn::Sub(next, s));
    s = hn::IfThenElse(live, next, s);
    live = hn::AndNot(hn::Le(moved, tolerance), live);
  }
  return s;
}

/// What a lane holds instead of a share of the path in [0, 1].
constexpr int NoCrossing = -1;
constexpr int SeveralChanges = -2;

/// \return true if some segments have to be searched one by one
template <typename Real>
HWY_INLINE bool FindShares(
  SegmentBatch<Real>& segments, const Paths<Real>& paths, bool isSolid, Real* shares)
{
  const hn::CappedTag<Real, WidestVector> d;
  using V = hn::Vec<decltype(d)>;
  using M = hn::Mask<decltype(d)>;
  const V zero = hn::Zero(d);
  M several = hn::Lt(zero, zero);
  for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); i += hn::Lanes(d))
  {
    if (!IsAnyWanted(segments, i))
    {
      continue;
    }
    V b[4];
    CubicsAlong(d, segments, paths, i, b);
    const M in0 = hn::Ge(b[0], zero), in1 = hn::Ge(b[1], zero);
    const M in2 = hn::Ge(b[2], zero), in3 = hn::Ge(b[3], zero);
    const M change01 = hn::Xor(in0, in1), change12 = hn::Xor(in1, in2);
    const M change23 = hn::Xor(in2, in3);
    const M any = hn::Or(hn::Or(change01, change12), change23);
    const M odd = hn::Xor(hn::Xor(change01, change12), change23);
    const M three = hn::And(hn::And(change01, change12), change23);
    const M one = hn::AndNot(three, odd);

    V share = hn::IfThenElse(any, hn::Set(d, Real(SeveralChanges)), hn::Set(d, Real(NoCrossing)));
    const M begins = isSolid ? in0 : hn::Lt(zero, zero);
    const M live = hn::AndNot(begins, one);
    if (!hn::AllFalse(d, live))
    {
      share = hn::IfThenElse(live, RefineCrossings<Real>(d, b, live), share);
    }
    several = hn::Or(several, hn::AndNot(begins, hn::AndNot(one, any)));
    hn::StoreU(hn::IfThenElse(begins, zero, share), d, shares + i);
    hn::StoreU(b[0], d, &segments.AtEntry[i]);
  }
  return !hn::AllFalse(d, several);
}

/// Segment i, one by one, whose cubic changes its sign several times.
template <typename Real>
HWY_INLINE Real FindShare(
  const SegmentBatch<Real>& segments, const Paths<Real>& paths, std::size_t i)
{
  Corners<Real> corners;
  CellPath<Real> path;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    corners[corner] = segments.Corners[corner][i];
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    path.Begin[a] = paths.Begin[a][i];
    path.End[a] = paths.End[a][i];
  }
  Real share;
  return FirstCrossing(CubicAlong(corners, path), share) ? share : Real(NoCrossing);
}

HWY_INLINE hn::Vec<hn::CappedTag<double, WidestVector / 2>> LoadAsDoubles(const float* from)
{
  const hn::CappedTag<double, WidestVector / 2> d;
  return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, decltype(d)>(), from));
}
HWY_INLINE hn::Vec<hn::CappedTag<double, WidestVector / 2>> LoadAsDoubles(const double* from)
{
  return hn::LoadU(hn::CappedTag<double, WidestVector / 2>(), from);
}

template <typename Real>
HWY_INLINE void FindAll(SegmentBatch<Real>& segments, bool isSolid)
{
  Paths<Real> paths;
  RayBatch::Array<Real> shares;
  SetUpPaths(segments, FullVectors(segments), paths);
  if (FindShares(segments, paths, isSolid, shares.data()))
  {
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
    {
      if ((segments.Wanted >> i & 1u) != 0 && shares[i] == Real(SeveralChanges))
      {
        shares[i] = FindShare(segments, paths, i);
      }
    }
  }
  const hn::CappedTag<double, WidestVector / 2> d;
  const auto zero = hn::Zero(d);
  const auto infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); i += hn::Lanes(d))
  {
    if (!IsAnyWanted(segments, i))
    {
      continue;
    }
    const auto share = LoadAsDoubles(&shares[i]);
    const auto enter = hn::LoadU(d, &segments.Enter[i]);
    const auto length = hn::Sub(hn::LoadU(d, &paths.Leave[i]), enter);
    const auto isFound = hn::And(hn::Ge(share, zero), hn::Gt(length, zero));
    const auto distance = hn::Add(enter, hn::Mul(share, length));
    hn::StoreU(hn::IfThenElse(isFound, distance, infinity), d, &segments.Distance[i]);
  }
}

void FindFloat(SegmentBatch<float>& segments, bool isSolid)
{
  FindAll(segments, isSolid);
}

void FindDouble(SegmentBatch<double>& segments, bool isSolid)
{
  FindAll(segments, isSolid);
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

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Fewer segments than this are searched one by one. Measured by `BenchmarkKernels`, crossings.
constexpr int FewestForVectors = 3;

template <typename Real>
void FindOneByOne(SegmentBatch<Real>& in, bool isSolid)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.Count); ++i)
  {
    const CellSegment<Real> segment(in, i);
    const Cubic<Real> cubic = CubicAlong(segment.Values, segment.Path);
    in.Enter[i] = segment.Enter;
    in.AtEntry[i] = cubic[0];
    Real share = Real(0);
    const bool begins = isSolid && IsInside(cubic[0]);
    const bool isFound = begins || FirstCrossing(cubic, share);
    in.Distance[i] = isFound ? segment.DistanceAt(static_cast<double>(share)) : Infinity;
  }
}

template <typename Real>
void FindNearest(SegmentBatch<Real>& in)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.Count); ++i)
  {
    const CellSegment<Real> segment(in, i);
    in.Enter[i] = segment.Enter;
    in.AtEntry[i] = segment.Values[NearestCorner(segment.Path.Begin)];
    in.Distance[i] = Infinity;
    double share;
    if (segment.Enter < segment.Leave &&
      FirstNearestCrossing(segment.Values, segment.Nearest(in, i), share))
    {
      in.Distance[i] = segment.DistanceAt(share);
    }
  }
}

}

namespace SegmentKernels
{
HWY_EXPORT(FindFloat);
HWY_EXPORT(FindDouble);
}

void FindCrossings(SegmentBatch<float>& segments, bool isSolid)
{
  using namespace SegmentKernels;
  if (segments.Count < FewestForVectors)
  {
    FindOneByOne(segments, isSolid);
    return;
  }
  FillLastVector(segments);
  HWY_DYNAMIC_DISPATCH(FindFloat)(segments, isSolid);
}

void FindCrossings(SegmentBatch<double>& segments, bool isSolid)
{
  using namespace SegmentKernels;
  if (segments.Count < FewestForVectors)
  {
    FindOneByOne(segments, isSolid);
    return;
  }
  FillLastVector(segments);
  HWY_DYNAMIC_DISPATCH(FindDouble)(segments, isSolid);
}

void FindCrossingsOneByOne(SegmentBatch<float>& segments, bool isSolid)
{
  FindOneByOne(segments, isSolid);
}

void FindCrossingsOneByOne(SegmentBatch<double>& segments, bool isSolid)
{
  FindOneByOne(segments, isSolid);
}

void FindNearestCrossings(SegmentBatch<float>& segments)
{
  FindNearest(segments);
}

void FindNearestCrossings(SegmentBatch<double>& segments)
{
  FindNearest(segments);
}

}
#endif
