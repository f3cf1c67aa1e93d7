// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelsCrossing.h"

#include "CellRoot.h"

#include <algorithm>
#include <limits>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "KernelsCrossing.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
HWY_INLINE V Mix(V a, V b, V weightOfB)
{
  const hn::DFromV<V> d;
  return hn::Add(hn::Mul(hn::Sub(hn::Set(d, 1), weightOfB), a), hn::Mul(weightOfB, b));
}

/// Store doubles as Real.
template <class V>
HWY_INLINE void StoreAs(V value, double* to)
{
  hn::StoreU(value, hn::DFromV<V>(), to);
}
template <class V>
HWY_INLINE void StoreAs(V value, float* to)
{
  const hn::Rebind<float, hn::DFromV<V>> df;
  hn::StoreU(hn::DemoteTo(df, value), df, to);
}

/// Where each passage leaves its cell, and its path in the cell's coordinates.
template <typename Real>
struct Paths
{
  RayBatch::Array<double> Leave;
  std::array<RayBatch::Array<Real>, 3> Begin, End;
};

template <typename Real>
HWY_INLINE void SetUpPaths(PassageBatch<Real>& in, std::size_t count, Paths<Real>& out)
{
  const hn::CappedTag<double, WidestVector / 2> d;
  using V = hn::Vec<decltype(d)>;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    V origin[3], direction[3], cell[3], ahead[3], enter[3], leave[3];
    V first = hn::LoadU(d, &in.Begin[i]);
    V last = hn::LoadU(d, &in.End[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      origin[a] = hn::LoadU(d, &in.Origin[a][i]);
      direction[a] = hn::LoadU(d, &in.Direction[a][i]);
      cell[a] = hn::LoadU(d, &in.Cell[a][i]);
      const V inverse = hn::LoadU(d, &in.Inverse[a][i]);
      ahead[a] = hn::IfThenElse(hn::Gt(direction[a], zero), one, zero);
      const V behind = hn::Add(cell[a], hn::Sub(one, ahead[a]));
      enter[a] = hn::Mul(hn::Sub(behind, origin[a]), inverse);
      leave[a] = hn::Mul(hn::Sub(hn::Add(cell[a], ahead[a]), origin[a]), inverse);
      first = hn::Max(first, enter[a]);
      last = hn::Min(last, leave[a]);
    }
    hn::StoreU(first, d, &in.Enter[i]);
    hn::StoreU(last, d, &out.Leave[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      // On a face the coordinate is exactly 0 or 1, as the neighbour across the face has it.
      const auto at = [&](V t) HWY_ATTR
      {
        const V x = hn::Sub(hn::Add(origin[a], hn::Mul(t, direction[a])), cell[a]);
        return hn::Min(hn::Max(x, zero), one);
      };
      const V begin = hn::IfThenElse(hn::Eq(first, enter[a]), hn::Sub(one, ahead[a]), at(first));
      const V end = hn::IfThenElse(hn::Eq(last, leave[a]), ahead[a], at(last));
      StoreAs(begin, &out.Begin[a][i]);
      StoreAs(end, &out.End[a][i]);
    }
  }
}

/// CubicAlong of CellRoot.h.
template <typename Real, class D, class V = hn::Vec<D>>
HWY_INLINE void CubicsAlong(
  D d, const PassageBatch<Real>& in, const Paths<Real>& paths, std::size_t i, V b[4])
{
  V v[8], alongX[8], alongXY[8], box[8];
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    v[corner] = hn::LoadU(d, &in.Corners[corner][i]);
  }
  const V beginX = hn::LoadU(d, &paths.Begin[0][i]), endX = hn::LoadU(d, &paths.End[0][i]);
  const V beginY = hn::LoadU(d, &paths.Begin[1][i]), endY = hn::LoadU(d, &paths.End[1][i]);
  const V beginZ = hn::LoadU(d, &paths.Begin[2][i]), endZ = hn::LoadU(d, &paths.End[2][i]);
  for (std::size_t row = 0; row < 8; row += 2)
  {
    alongX[row] = Mix(v[row], v[row + 1], beginX);
    alongX[row + 1] = Mix(v[row], v[row + 1], endX);
  }
  for (std::size_t slice = 0; slice < 8; slice += 4)
  {
    for (std::size_t x = 0; x < 2; ++x)
    {
      const V low = alongX[slice + x], high = alongX[slice + 2 + x];
      alongXY[slice + x] = Mix(low, high, beginY);
      alongXY[slice + 2 + x] = Mix(low, high, endY);
    }
  }
  for (std::size_t xy = 0; xy < 4; ++xy)
  {
    box[xy] = Mix(alongXY[xy], alongXY[4 + xy], beginZ);
    box[4 + xy] = Mix(alongXY[xy], alongXY[4 + xy], endZ);
  }
  const V third = hn::Set(d, Real(1) / Real(3));
  b[0] = box[0];
  b[1] = hn::Mul(hn::Add(hn::Add(box[1], box[2]), box[4]), third);
  b[2] = hn::Mul(hn::Add(hn::Add(box[6], box[5]), box[3]), third);
  b[3] = box[7];
}

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

/// What a lane found instead of a share of the path in [0, 1].
constexpr int NoCrossing = -1;
constexpr int SeveralChanges = -2;

template <typename Real>
HWY_INLINE void FindShares(
  PassageBatch<Real>& passages, const Paths<Real>& paths, bool isSolid, Real* shares)
{
  const hn::CappedTag<Real, WidestVector> d;
  using V = hn::Vec<decltype(d)>;
  using M = hn::Mask<decltype(d)>;
  const V zero = hn::Zero(d);
  for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); i += hn::Lanes(d))
  {
    V b[4];
    CubicsAlong(d, passages, paths, i, b);
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
    hn::StoreU(hn::IfThenElse(begins, zero, share), d, shares + i);
    hn::StoreU(b[0], d, &passages.AtEntry[i]);
  }
}

template <typename Real>
HWY_INLINE void FindAll(PassageBatch<Real>& passages, bool isSolid)
{
  Paths<Real> paths;
  RayBatch::Array<Real> shares;
  // As far as the last vector of Real reaches, which holds more lanes than one of double.
  const std::size_t lanes = hn::Lanes(hn::CappedTag<Real, WidestVector>());
  const auto count = static_cast<std::size_t>(passages.Count);
  SetUpPaths(passages, (count + lanes - 1) / lanes * lanes, paths);
  FindShares(passages, paths, isSolid, shares.data());
  for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
  {
    const double length = paths.Leave[i] - passages.Enter[i];
    Real share = shares[i];
    if (share == Real(SeveralChanges))
    {
      Corners<Real> corners;
      CellPath<Real> path;
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        corners[corner] = passages.Corners[corner][i];
      }
      for (std::size_t a = 0; a < 3; ++a)
      {
        path.Begin[a] = paths.Begin[a][i];
        path.End[a] = paths.End[a][i];
      }
      share = FirstCrossing(CubicAlong(corners, path), share) ? share : Real(NoCrossing);
    }
    const bool isFound = share >= Real(0) && length > 0.0;
    passages.Distance[i] = isFound ? passages.Enter[i] + static_cast<double>(share) * length
                                   : std::numeric_limits<double>::infinity();
  }
}

void FindFloat(PassageBatch<float>& passages, bool isSolid)
{
  FindAll(passages, isSolid);
}

void FindDouble(PassageBatch<double>& passages, bool isSolid)
{
  FindAll(passages, isSolid);
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

/// Fewer passages than this are not worth a vector.
constexpr int FewestForVectors = 3;

/// One passage: where the ray enters and leaves its cell, and the path between.
template <typename Real>
struct Passage
{
  Passage(const PassageBatch<Real>& in, std::size_t i)
    : Enter(in.Begin[i])
    , Leave(in.End[i])
  {
    std::array<double, 3> enter, leave;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double ahead = in.Direction[a][i] > 0.0 ? 1.0 : 0.0;
      enter[a] = (in.Cell[a][i] + (1.0 - ahead) - in.Origin[a][i]) * in.Inverse[a][i];
      leave[a] = (in.Cell[a][i] + ahead - in.Origin[a][i]) * in.Inverse[a][i];
      this->Enter = std::max(this->Enter, enter[a]);
      this->Leave = std::min(this->Leave, leave[a]);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      // On a face the coordinate is exactly 0 or 1, as the neighbour across the face has it.
      const auto at = [&](double t)
      {
        const double x = in.Origin[a][i] + t * in.Direction[a][i] - in.Cell[a][i];
        return static_cast<Real>(std::min(std::max(x, 0.0), 1.0));
      };
      const Real ahead = in.Direction[a][i] > 0.0 ? Real(1) : Real(0);
      this->Path.Begin[a] = this->Enter == enter[a] ? Real(1) - ahead : at(this->Enter);
      this->Path.End[a] = this->Leave == leave[a] ? ahead : at(this->Leave);
    }
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      this->Values[corner] = in.Corners[corner][i];
    }
  }

  /// t at a share of the path; infinity if the ray only touches the cell.
  double DistanceAt(double share) const
  {
    return this->Enter < this->Leave ? this->Enter + share * (this->Leave - this->Enter) : Infinity;
  }

  double Enter, Leave;
  CellPath<Real> Path;
  Corners<Real> Values;
};

template <typename Real>
void FindOneByOne(PassageBatch<Real>& in, bool isSolid)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.Count); ++i)
  {
    const Passage<Real> passage(in, i);
    const Cubic<Real> cubic = CubicAlong(passage.Values, passage.Path);
    in.Enter[i] = passage.Enter;
    in.AtEntry[i] = cubic[0];
    Real share = Real(0);
    const bool begins = isSolid && IsInside(cubic[0]);
    const bool isFound = begins || FirstCrossing(cubic, share);
    in.Distance[i] = isFound ? passage.DistanceAt(static_cast<double>(share)) : Infinity;
  }
}

template <typename Real>
void FindNearest(PassageBatch<Real>& in)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.Count); ++i)
  {
    const Passage<Real> passage(in, i);
    const double length = passage.Leave - passage.Enter;
    in.Enter[i] = passage.Enter;
    in.AtEntry[i] = passage.Values[NearestCorner(passage.Path.Begin)];
    in.Distance[i] = Infinity;
    if (!(length > 0.0))
    {
      continue;
    }
    std::array<double, 3> midway;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double middle = in.Cell[a][i] + 0.5 - in.Origin[a][i];
      midway[a] = (middle * in.Inverse[a][i] - passage.Enter) / length;
    }
    double share;
    if (FirstNearestCrossing(passage.Values, passage.Path, midway, share))
    {
      in.Distance[i] = passage.DistanceAt(share);
    }
  }
}

/// Repeat the last passage up to the end of the last vector, so that no lane holds what is not a
/// number of ours.
template <typename Real>
void FillLastVector(PassageBatch<Real>& in)
{
  const auto count = static_cast<std::size_t>(in.Count);
  const std::size_t end = WholeVectors(count);
  const auto fill = [&](auto& array)
  {
    std::fill(array.begin() + static_cast<std::ptrdiff_t>(count),
      array.begin() + static_cast<std::ptrdiff_t>(end), array[count - 1]);
  };
  for (std::size_t a = 0; a < 3; ++a)
  {
    fill(in.Origin[a]);
    fill(in.Direction[a]);
    fill(in.Inverse[a]);
    fill(in.Cell[a]);
  }
  fill(in.Begin);
  fill(in.End);
  for (auto& corner : in.Corners)
  {
    fill(corner);
  }
}

}

HWY_EXPORT(FindFloat);
HWY_EXPORT(FindDouble);

void FindCrossings(PassageBatch<float>& passages, bool isSolid)
{
  if (passages.Count < FewestForVectors)
  {
    FindOneByOne(passages, isSolid);
    return;
  }
  FillLastVector(passages);
  HWY_DYNAMIC_DISPATCH(FindFloat)(passages, isSolid);
}

void FindCrossings(PassageBatch<double>& passages, bool isSolid)
{
  if (passages.Count < FewestForVectors)
  {
    FindOneByOne(passages, isSolid);
    return;
  }
  FillLastVector(passages);
  HWY_DYNAMIC_DISPATCH(FindDouble)(passages, isSolid);
}

void FindCrossingsOneByOne(PassageBatch<float>& passages, bool isSolid)
{
  FindOneByOne(passages, isSolid);
}

void FindCrossingsOneByOne(PassageBatch<double>& passages, bool isSolid)
{
  FindOneByOne(passages, isSolid);
}

void FindNearestCrossings(PassageBatch<float>& passages)
{
  FindNearest(passages);
}

void FindNearestCrossings(PassageBatch<double>& passages)
{
  FindNearest(passages);
}

}
#endif
