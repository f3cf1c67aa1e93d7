// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Paths of rays through cells, and where cubics along them cross zero, in vectors. Kernels include
// this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsSegment_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsSegment_inl_h
#undef TemporalCoherence_KernelsSegment_inl_h
#else
#define TemporalCoherence_KernelsSegment_inl_h
#endif

#include "Lattice/SegmentBatch.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace SegmentKernels
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

/// The end of each segment, and its path in the coordinates of the cell.
template <typename Real>
struct Paths
{
  RayBatch::Array<double> Leave;
  std::array<RayBatch::Array<Real>, 3> Begin, End;
};

/// A vector of rays.
template <class V>
struct RayVector
{
  V Origin[3], Direction[3], Inverse[3];
  V Begin, End;
};

/// A vector of rays of a batch, from ray i on.
template <class D>
HWY_INLINE RayVector<hn::Vec<D>> LoadRays(D d, const RayBatch& rays, std::size_t i)
{
  RayVector<hn::Vec<D>> loaded;
  for (std::size_t a = 0; a < 3; ++a)
  {
    loaded.Origin[a] = hn::LoadU(d, &rays.Origin[a][i]);
    loaded.Direction[a] = hn::LoadU(d, &rays.Direction[a][i]);
    loaded.Inverse[a] = hn::LoadU(d, &rays.Inverse[a][i]);
  }
  loaded.Begin = hn::LoadU(d, &rays.Begin[i]);
  loaded.End = hn::LoadU(d, &rays.End[i]);
  return loaded;
}

/// Entry and exit of a vector of rays in cells, and their paths in cell coordinates.
template <class V>
struct PathVector
{
  V Enter, Leave;
  V Begin[3], End[3];
};

/// \param low, high corners of cells
/// \tparam AreUnits all edges of cells have length 1
template <bool AreUnits, class D, class V = hn::Vec<D>>
HWY_INLINE PathVector<V> FindPath(D d, const RayVector<V>& rays, const V low[3], const V high[3])
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  PathVector<V> path;
  path.Enter = rays.Begin;
  path.Leave = rays.End;
  V ahead[3], enter[3], leave[3];
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto isAscending = hn::Gt(rays.Direction[a], zero);
    ahead[a] = hn::IfThenElse(isAscending, one, zero);
    const V first = hn::IfThenElse(isAscending, low[a], high[a]);
    const V second = hn::IfThenElse(isAscending, high[a], low[a]);
    enter[a] = hn::Mul(hn::Sub(first, rays.Origin[a]), rays.Inverse[a]);
    leave[a] = hn::Mul(hn::Sub(second, rays.Origin[a]), rays.Inverse[a]);
    path.Enter = hn::Max(path.Enter, enter[a]);
    path.Leave = hn::Min(path.Leave, leave[a]);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    // On a face the coordinate is exactly 0 or 1, as the neighbour across the face has it.
    const auto at = [&](V t) HWY_ATTR
    {
      const V x = hn::Sub(hn::Add(rays.Origin[a], hn::Mul(t, rays.Direction[a])), low[a]);
      const V share = AreUnits ? x : hn::Div(x, hn::Sub(high[a], low[a]));
      return hn::Min(hn::Max(share, zero), one);
    };
    path.Begin[a] =
      hn::IfThenElse(hn::Eq(path.Enter, enter[a]), hn::Sub(one, ahead[a]), at(path.Enter));
    path.End[a] = hn::IfThenElse(hn::Eq(path.Leave, leave[a]), ahead[a], at(path.Leave));
  }
  return path;
}

/// Paths of rays in unit cells between integers.
/// \param cell first corners
template <class D, class V = hn::Vec<D>>
HWY_INLINE PathVector<V> FindPath(D d, const RayVector<V>& rays, const V cell[3])
{
  const V one = hn::Set(d, 1.0);
  const V high[3] = { hn::Add(cell[0], one), hn::Add(cell[1], one), hn::Add(cell[2], one) };
  return FindPath<true>(d, rays, cell, high);
}

/// True if the widest vector around segment i contains a wanted segment.
template <typename Real>
HWY_INLINE bool IsAnyWanted(const SegmentBatch<Real>& in, std::size_t i)
{
  constexpr std::uint64_t all = (std::uint64_t(1) << WidestVector) - 1;
  return (in.Wanted >> i / WidestVector * WidestVector & all) != 0;
}

/// \tparam AreBoxes cells lie between their first corners and their last
template <bool AreBoxes = false, typename Real>
HWY_INLINE void SetUpPaths(SegmentBatch<Real>& in, std::size_t count, Paths<Real>& out)
{
  const hn::CappedTag<double, WidestVector / 2> d;
  using V = hn::Vec<decltype(d)>;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    if (!IsAnyWanted(in, i))
    {
      continue;
    }
    RayVector<V> rays;
    V cell[3], last[3];
    rays.Begin = hn::LoadU(d, in.BeginOf() + i);
    rays.End = hn::LoadU(d, in.EndOf() + i);
    for (std::size_t a = 0; a < 3; ++a)
    {
      rays.Origin[a] = hn::LoadU(d, in.OriginOf(a) + i);
      rays.Direction[a] = hn::LoadU(d, in.DirectionOf(a) + i);
      rays.Inverse[a] = hn::LoadU(d, in.InverseOf(a) + i);
      cell[a] = hn::LoadU(d, &in.Cell[a][i]);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      last[a] = AreBoxes ? hn::LoadU(d, &in.Last[a][i]) : hn::Add(cell[a], hn::Set(d, 1.0));
    }
    const PathVector<V> path = FindPath<!AreBoxes>(d, rays, cell, last);
    hn::StoreU(path.Enter, d, &in.Enter[i]);
    hn::StoreU(path.Leave, d, &out.Leave[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      StoreAs(path.Begin[a], &out.Begin[a][i]);
      StoreAs(path.End[a], &out.End[a][i]);
    }
  }
}

/// CubicAlong of CellRoot.h.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void CubicsBetween(D d, const V v[8], const V begin[3], const V end[3], V b[4])
{
  V alongX[8], alongXY[8], box[8];
  for (std::size_t row = 0; row < 8; row += 2)
  {
    alongX[row] = Mix(v[row], v[row + 1], begin[0]);
    alongX[row + 1] = Mix(v[row], v[row + 1], end[0]);
  }
  for (std::size_t slice = 0; slice < 8; slice += 4)
  {
    for (std::size_t x = 0; x < 2; ++x)
    {
      const V low = alongX[slice + x], high = alongX[slice + 2 + x];
      alongXY[slice + x] = Mix(low, high, begin[1]);
      alongXY[slice + 2 + x] = Mix(low, high, end[1]);
    }
  }
  for (std::size_t xy = 0; xy < 4; ++xy)
  {
    box[xy] = Mix(alongXY[xy], alongXY[4 + xy], begin[2]);
    box[4 + xy] = Mix(alongXY[xy], alongXY[4 + xy], end[2]);
  }
  const V third = hn::Set(d, hn::TFromD<D>(1) / hn::TFromD<D>(3));
  b[0] = box[0];
  b[1] = hn::Mul(hn::Add(hn::Add(box[1], box[2]), box[4]), third);
  b[2] = hn::Mul(hn::Add(hn::Add(box[6], box[5]), box[3]), third);
  b[3] = box[7];
}

/// The cubics along the segments of a batch.
template <typename Real, class D, class V = hn::Vec<D>>
HWY_INLINE void CubicsAlong(
  D d, const SegmentBatch<Real>& in, const Paths<Real>& paths, std::size_t i, V b[4])
{
  V v[8], begin[3], end[3];
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    v[corner] = hn::LoadU(d, &in.Corners[corner][i]);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    begin[a] = hn::LoadU(d, &paths.Begin[a][i]);
    end[a] = hn::LoadU(d, &paths.End[a][i]);
  }
  CubicsBetween(d, v, begin, end, b);
}

/// How the signs of a cubic's coefficients change.
template <class M>
struct SignChanges
{
  M Begins; ///< the cubic is inside where it begins
  M Any;    ///< it may cross zero
  M One;    ///< it crosses zero once
};

template <class D, class V = hn::Vec<D>, class M = hn::Mask<D>>
HWY_INLINE SignChanges<M> FindChanges(D d, const V b[4])
{
  const V zero = hn::Zero(d);
  const M in0 = hn::Ge(b[0], zero), in1 = hn::Ge(b[1], zero);
  const M in2 = hn::Ge(b[2], zero), in3 = hn::Ge(b[3], zero);
  const M change01 = hn::Xor(in0, in1), change12 = hn::Xor(in1, in2);
  const M change23 = hn::Xor(in2, in3);
  const M any = hn::Or(hn::Or(change01, change12), change23);
  const M odd = hn::Xor(hn::Xor(change01, change12), change23);
  const M three = hn::And(hn::And(change01, change12), change23);
  return { in0, any, hn::AndNot(three, odd) };
}

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

/// Refine the roots of one vector until they are exact.
/// \param live lanes to refine
template <typename Real, class D, class V = hn::Vec<D>, class M = hn::Mask<D>>
HWY_INLINE V RefineCrossings(D d, const V b[4], M live)
{
  using Steps = Refinement<Real, D>;
  Steps root;
  root.Begin(d, b, live);
  for (int step = 0; step < Steps::MostSteps && !hn::AllFalse(d, root.Live); ++step)
  {
    root.Step(d);
  }
  return root.S;
}

/// The number of segments rounded up to whole vectors of Real, which have more lanes than those of
/// double.
template <typename Real>
HWY_INLINE std::size_t FullVectors(const SegmentBatch<Real>& segments)
{
  const std::size_t lanes = hn::Lanes(hn::CappedTag<Real, WidestVector>());
  return (static_cast<std::size_t>(segments.Count) + lanes - 1) / lanes * lanes;
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
