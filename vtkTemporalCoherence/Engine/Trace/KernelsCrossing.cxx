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
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// RefineCrossing of CellRoot.h on [0, 1], step by step.
template <typename Real, class D, class V = hn::Vec<D>, class M = hn::Mask<D>>
struct Refinement
{
  static constexpr int MostSteps = 32;

  /// \param live lanes to refine
  HWY_INLINE void Begin(D d, const V b[4], M live)
  {
    const V zero = hn::Zero(d), one = hn::Set(d, Real(1)), two = hn::Set(d, Real(2));
    const V three = hn::Set(d, Real(3)), half = hn::Set(d, Real(0.5));
    const V step01 = hn::Sub(b[1], b[0]), step12 = hn::Sub(b[2], b[1]);
    this->C0 = b[0];
    this->C1 = hn::Mul(three, step01);
    this->C2 = hn::Mul(three, hn::Sub(step12, step01));
    this->C3 = hn::Sub(hn::Sub(b[3], b[0]), hn::Mul(three, step12));
    this->Slope3 = hn::Mul(three, this->C3);
    this->Slope2 = hn::Mul(two, this->C2);
    this->InsideLow = hn::Ge(b[0], zero);
    const M differs = hn::Ne(b[3], b[0]);
    const V span = hn::IfThenElse(differs, hn::Sub(b[0], b[3]), one);
    const V chord = hn::IfThenElse(differs, hn::Div(b[0], span), half);
    this->Low = zero;
    this->High = one;
    this->S = hn::Min(hn::Max(chord, hn::Set(d, Real(0.0625))), hn::Set(d, Real(0.9375)));
    this->Live = live;
  }

  HWY_INLINE void Step(D d)
  {
    const V tolerance = hn::Set(d, sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12));
    const V zero = hn::Zero(d), one = hn::Set(d, Real(1)), two = hn::Set(d, Real(2));
    const V half = hn::Set(d, Real(0.5)), s = this->S;
    const V value = hn::Add(
      hn::Mul(hn::Add(hn::Mul(hn::Add(hn::Mul(this->C3, s), this->C2), s), this->C1), s), this->C0);
    const V slope = hn::Add(hn::Mul(hn::Add(hn::Mul(this->Slope3, s), this->Slope2), s), this->C1);
    const M isLow = hn::Not(hn::Xor(hn::Ge(value, zero), this->InsideLow));
    this->Low = hn::IfThenElse(isLow, s, this->Low);
    this->High = hn::IfThenElse(isLow, this->High, s);
    const M isFlat = hn::Eq(slope, zero);
    const V newton = hn::Div(hn::Neg(value), hn::IfThenElse(isFlat, one, slope));
    const V distance = hn::IfThenElse(isFlat, two, newton);
    V next = hn::Add(s, distance);
    const M isOut = hn::Not(hn::And(hn::Gt(next, this->Low), hn::Lt(next, this->High)));
    const V width = hn::Sub(this->High, this->Low);
    const M isDone =
      hn::And(isOut, hn::Or(hn::Le(hn::Abs(distance), tolerance), hn::Le(width, tolerance)));
    this->Live = hn::AndNot(isDone, this->Live);
    next = hn::IfThenElse(isOut, hn::Mul(half, hn::Add(this->Low, this->High)), next);
    const V moved = hn::Abs(hn::Sub(next, s));
    this->S = hn::IfThenElse(this->Live, next, s);
    this->Live = hn::AndNot(hn::Le(moved, tolerance), this->Live);
  }

  V C0, C1, C2, C3, Slope2, Slope3;
  V Low, High, S;
  M InsideLow, Live;
};

/// What a lane holds instead of a share of the path in [0, 1].
constexpr int NoCrossing = -1;
constexpr int SeveralChanges = -2;

/// Shares of a vector of paths.
template <typename Real>
struct ShareSearch
{
  using D = hn::CappedTag<Real, WidestVector>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  HWY_INLINE ShareSearch(
    SegmentBatch<Real>& segments, const Paths<Real>& paths, bool isSolid, std::size_t i)
  {
    const D d;
    const V zero = hn::Zero(d);
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
    const M begins = isSolid ? in0 : hn::Lt(zero, zero);
    this->Several = hn::AndNot(begins, hn::AndNot(one, any));
    this->One = hn::AndNot(begins, one);
    const V unknown =
      hn::IfThenElse(any, hn::Set(d, Real(SeveralChanges)), hn::Set(d, Real(NoCrossing)));
    this->Others = hn::IfThenElse(begins, zero, unknown);
    this->Root.Begin(d, b, this->One);
    hn::StoreU(b[0], d, &segments.AtEntry[i]);
  }

  HWY_INLINE bool IsDone() const { return hn::AllFalse(D(), this->Root.Live); }
  HWY_INLINE V Shares() const { return hn::IfThenElse(this->One, this->Root.S, this->Others); }

  M Several, One;
  V Others; ///< shares of paths without a single change
  Refinement<Real, D> Root;
};

/// \return true if some segments have to be searched one by one
template <typename Real>
HWY_INLINE bool FindShares(
  SegmentBatch<Real>& segments, const Paths<Real>& paths, bool isSolid, Real* shares)
{
  using Search = ShareSearch<Real>;
  const typename Search::D d;
  const std::size_t lanes = hn::Lanes(d), count = static_cast<std::size_t>(segments.Count);
  auto several = hn::Lt(hn::Zero(d), hn::Zero(d));
  // Two vectors at a time, as the steps of each depend on those before. The last may be alone.
  for (std::size_t i = 0; i < count; i += 2 * lanes)
  {
    const std::size_t next = i + lanes < count && IsAnyWanted(segments, i + lanes) ? i + lanes : i;
    const std::size_t here = IsAnyWanted(segments, i) ? i : next;
    if (!IsAnyWanted(segments, here))
    {
      continue;
    }
    Search first(segments, paths, isSolid, here), second(segments, paths, isSolid, next);
    for (int step = 0;
         step < decltype(Search::Root)::MostSteps && !(first.IsDone() && second.IsDone()); ++step)
    {
      first.Root.Step(d);
      second.Root.Step(d);
    }
    several = hn::Or(several, hn::Or(first.Several, second.Several));
    hn::StoreU(first.Shares(), d, shares + here);
    hn::StoreU(second.Shares(), d, shares + next);
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

HWY_EXPORT(FindFloat);
HWY_EXPORT(FindDouble);

void FindCrossings(SegmentBatch<float>& segments, bool isSolid)
{
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
