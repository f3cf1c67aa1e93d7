// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/KernelsCells.h"

#include "Mesh/HexahedronRoots.h"

#include <algorithm>
#include <cmath>
#include <limits>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/KernelsHexahedra.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/KernelsRoots-inl.h"
#include "Mesh/KernelsSheared-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// A hexahedron as rays see it; x, y and the differences are the functions whose roots are wanted.
template <class D>
struct SeenCell
{
  using V = hn::Vec<D>;
  V Functions[3][8], T[8];
};

template <class D, class Points>
HWY_INLINE void See(const ShearedRays<D>& rays, const Points& points, SeenCell<D>& seen)
{
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    rays.See(points, corner, seen.Functions[0][corner], seen.Functions[1][corner], seen.T[corner]);
    seen.Functions[2][corner] = points.Value(corner);
  }
}

template <class V>
HWY_INLINE void FindRange(const V corners[8], V& low, V& high)
{
  low = high = corners[0];
  for (std::size_t corner = 1; corner < 8; ++corner)
  {
    low = hn::Min(low, corners[corner]);
    high = hn::Max(high, corners[corner]);
  }
}

/// A search in a vector of systems.
template <class D>
struct RootSearch
{
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Use = RootVectors<D>;

  /// Lanes that may have roots between Begin and End, by the values at corners.
  HWY_INLINE M Begin(const ShearedRays<D>& rays, const SeenCell<D>& seen)
  {
    const D d;
    const V zero = hn::Zero(d);
    V low, high;
    FindRange(seen.T, low, high);
    M isLeft = hn::And(hn::Le(low, rays.End), hn::Ge(high, rays.Begin));
    for (std::size_t i = 0; i < 3; ++i)
    {
      FindRange(seen.Functions[i], low, high);
      const M isBelow = i == 2 ? hn::Ge(low, zero) : hn::Gt(low, zero);
      isLeft = hn::AndNot(hn::Or(isBelow, hn::Lt(high, zero)), isLeft);
      this->Largest[i] = hn::Max(hn::Neg(low), high);
    }
    this->Active = isLeft;
    return isLeft;
  }

  HWY_INLINE void SetUp(const SeenCell<D>& seen)
  {
    const D d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const M isZero = hn::Eq(this->Largest[i], zero);
      const V scale = hn::Div(one, hn::IfThenElse(isZero, one, this->Largest[i]));
      Use::Coefficients(seen.Functions[i], scale, this->System[i]);
      this->Box.Middle[i] = zero;
      this->Box.Half[i] = one;
    }
    this->IsOnly = this->IsUnknown = hn::Lt(zero, zero);
  }

  /// Cut off where there is no root, and find lanes with one root at most.
  /// \return true if another round may find more
  HWY_INLINE bool Round(bool isFirst)
  {
    const D d;
    V local[3][8];
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t k = 0; k < 8; ++k)
      {
        local[i][k] = this->System[i][k];
      }
      if (!isFirst)
      {
        this->Restrict(local[i]);
      }
    }
    NearlyLinear<D> near;
    V rest[3], steepest;
    const M isRegular = near.SetUp(local);
    near.Bound(rest, steepest);
    const V error = hn::Max(hn::Max(near.Error[0], near.Error[1]), near.Error[2]);
    const V one = hn::Set(d, 1.0), minusOne = hn::Set(d, -1.0), zero = hn::Zero(d);
    V low[3], high[3];
    M isEmpty = hn::Lt(one, zero), isShorter = isEmpty;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V reach = Use::Three(rest[i], near.Error[i], hn::Set(d, Margin));
      low[i] = hn::Max(hn::Neg(hn::Add(near.Parts[i][0], reach)), minusOne);
      high[i] = hn::Min(hn::Sub(reach, near.Parts[i][0]), one);
      isEmpty = hn::Or(isEmpty, hn::Gt(low[i], high[i]));
      isShorter = hn::Or(isShorter, hn::Lt(hn::Sub(high[i], low[i]), hn::Set(d, 1.2)));
    }
    this->Active = hn::AndNot(hn::And(isRegular, isEmpty), this->Active);
    const M isWell = hn::And(isRegular, hn::Lt(error, hn::Set(d, MostError)));
    const M isOnly =
      hn::And(this->Active, hn::And(isWell, hn::Lt(steepest, hn::Set(d, MostNonlinear))));
    if (isFirst)
    {
      this->Near = near;
    }
    else
    {
      this->Near.Take(isOnly, near);
    }
    this->IsOnly = hn::Or(this->IsOnly, isOnly);
    this->Active = hn::AndNot(isOnly, this->Active);
    const M goesOn = hn::And(this->Active, hn::And(isRegular, isShorter));
    this->IsUnknown = hn::Or(this->IsUnknown, hn::AndNot(goesOn, this->Active));
    this->Active = goesOn;
    this->Cut(goesOn, low, high);
    return !hn::AllFalse(d, goesOn);
  }

  /// Solve the lanes with one root at most.
  /// \param at gets the roots
  /// \return lanes with a root
  HWY_INLINE M Solve(V at[3])
  {
    const D d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    V v[3], most[3], least[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      most[i] = hn::Add(hn::Add(one, hn::Set(d, Margin)), this->Near.Error[i]);
      least[i] = hn::Neg(most[i]);
      v[i] = hn::Max(least[i], hn::Min(hn::Neg(this->Near.Parts[i][0]), most[i]));
    }
    M isLive = this->IsOnly, isThere = hn::Lt(one, zero);
    for (int step = 0; step < MostNewtonSteps && !hn::AllFalse(d, isLive); ++step)
    {
      V move[3], longest = zero, moved = zero;
      this->Near.Step(v, move);
      M isNear = isLive;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const V next = hn::Max(least[i], hn::Min(hn::Sub(v[i], move[i]), most[i]));
        const V length = hn::Abs(move[i]);
        isNear = hn::And(isNear, hn::Le(length, hn::Add(hn::Set(d, Margin), this->Near.Error[i])));
        longest = hn::Max(longest, length);
        moved = hn::Max(moved, hn::Abs(hn::Sub(next, v[i])));
        v[i] = hn::IfThenElse(isLive, next, v[i]);
      }
      isThere = hn::Or(isThere, isNear);
      const M isDone =
        hn::Or(hn::Le(longest, hn::Set(d, LastStep)), hn::Le(moved, hn::Set(d, LastMove)));
      isLive = hn::AndNot(isDone, isLive);
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      at[i] = hn::Add(this->Box.Middle[i], hn::Mul(this->Box.Half[i], v[i]));
    }
    return isThere;
  }

  V Largest[3], System[3][8];
  RootBox<D> Box;
  NearlyLinear<D> Near; ///< of lanes with one root at most
  M Active, IsOnly, IsUnknown;

private:
  HWY_INLINE void Restrict(V c[8]) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::size_t bit = std::size_t(1) << a;
      for (std::size_t k = 0; k < 8; ++k)
      {
        if ((k & bit) == 0)
        {
          c[k] = hn::Add(c[k], hn::Mul(this->Box.Middle[a], c[k + bit]));
          c[k + bit] = hn::Mul(this->Box.Half[a], c[k + bit]);
        }
      }
    }
  }

  HWY_INLINE void Cut(M lanes, const V low[3], const V high[3])
  {
    const V half = hn::Set(D(), 0.5);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V middle = hn::Mul(half, hn::Add(low[i], high[i]));
      const V length = hn::Mul(half, hn::Sub(high[i], low[i]));
      const V moved = hn::Add(this->Box.Middle[i], hn::Mul(middle, this->Box.Half[i]));
      this->Box.Middle[i] = hn::IfThenElse(lanes, moved, this->Box.Middle[i]);
      this->Box.Half[i] =
        hn::IfThenElse(lanes, hn::Mul(length, this->Box.Half[i]), this->Box.Half[i]);
    }
  }
};

/// Append the roots of lanes that have one at most.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void AppendRoots(RootSearch<D>& search, const SeenCell<D>& seen, const MeshRays& rays,
  std::size_t i, std::uint64_t wanted, Crossings& found)
{
  using Use = RootVectors<D>;
  const D d;
  V at[3], distances[8], x[3], y[3], along[3], slope[3];
  wanted &= BitsOf(d, search.Solve(at));
  if (wanted == 0)
  {
    return;
  }
  const V zero = hn::Zero(d);
  Use::Coefficients(seen.T, hn::Set(d, 1.0), distances);
  Use::GradientAt(search.System[0], at, x);
  Use::GradientAt(search.System[1], at, y);
  Use::Cross(x, y, along);
  Use::GradientAt(search.System[2], at, slope);
  const auto isUp = hn::Gt(Use::Dot(along, slope), zero);
  Use::GradientAt(distances, at, slope);
  const auto isAhead = hn::Gt(Use::Dot(along, slope), zero);
  const std::uint64_t falling = BitsOf(d, hn::Xor(isUp, isAhead));
  HWY_ALIGN double t[hn::MaxLanes(d)];
  hn::Store(hn::Add(Use::ValueAt(distances, at), zero), d, t);
  for (; wanted != 0; wanted &= wanted - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(wanted));
    if (t[lane] >= rays.Begin[i + lane] && t[lane] <= rays.End[i + lane])
    {
      found.Append(i + lane, t[lane], (falling >> lane & 1u) == 0);
    }
  }
}

/// Search a lane alone.
template <class D>
HWY_NOINLINE void AppendSearched(const SeenCell<D>& seen, const MeshRays& rays, std::size_t i,
  std::uint64_t wanted, Crossings& found)
{
  const D d;
  HWY_ALIGN double all[4][8][hn::MaxLanes(d)];
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    hn::Store(seen.Functions[0][corner], d, all[0][corner]);
    hn::Store(seen.Functions[1][corner], d, all[1][corner]);
    hn::Store(seen.Functions[2][corner], d, all[2][corner]);
    hn::Store(seen.T[corner], d, all[3][corner]);
  }
  for (; wanted != 0; wanted &= wanted - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(wanted));
    SeenHexahedron cell;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      cell.X[corner] = all[0][corner][lane];
      cell.Y[corner] = all[1][corner][lane];
      cell.Difference[corner] = all[2][corner][lane];
      cell.T[corner] = all[3][corner][lane];
    }
    HexahedronRoots roots;
    FindRoots(cell, roots);
    for (std::size_t root = 0; root < roots.Count; ++root)
    {
      const double t = roots.Roots[root].T;
      if (t >= rays.Begin[i + lane] && t <= rays.End[i + lane])
      {
        found.Append(i + lane, t, roots.Roots[root].Rises);
      }
    }
  }
}

template <class D, class Points>
HWY_INLINE void FindCrossings(const ShearedRays<D>& vector, const Points& points,
  const MeshRays& rays, std::size_t i, std::uint64_t wanted, Crossings& found)
{
  const D d;
  SeenCell<D> seen;
  See(vector, points, seen);
  RootSearch<D> search;
  wanted &= BitsOf(d, search.Begin(vector, seen));
  if (wanted == 0)
  {
    return;
  }
  search.SetUp(seen);
  for (int round = 0; round < MostRounds; ++round)
  {
    if (!search.Round(round == 0))
    {
      break;
    }
  }
  const std::uint64_t only = wanted & BitsOf(d, search.IsOnly);
  if (only != 0)
  {
    AppendRoots(search, seen, rays, i, only, found);
  }
  const std::uint64_t unknown = wanted & BitsOf(d, hn::Or(search.IsUnknown, search.Active));
  if (unknown != 0)
  {
    AppendSearched(seen, rays, i, unknown, found);
  }
}

void HexahedronCrossingsOf(
  const CornerPoints<8>& points, const MeshRays& rays, std::uint64_t which, Crossings& found)
{
  ForEachVector(rays, which, points,
    [&](auto, const auto& seen, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    { FindCrossings(vector, seen, rays, i, wanted, found); });
}

void HexahedronPairCrossingsOf(const TurnedPairs<8>& pairs, const MeshRays& rays, Crossings& found)
{
  ForEachVectorOfPairs(rays, pairs,
    [&](auto, const auto& seen, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    { FindCrossings(vector, seen, rays, i, wanted, found); });
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace MeshKernels
{

HWY_EXPORT(HexahedronCrossingsOf);
HWY_EXPORT(HexahedronPairCrossingsOf);

void HexahedronCrossings(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, Crossings& found)
{
  const CornerPoints<8> points = { cell.Points, differences };
  HWY_DYNAMIC_DISPATCH(HexahedronCrossingsOf)(points, rays, which, found);
}

void HexahedronCrossingsOfPairs(
  const MeshCell* cells, const CellDifferences* differences, const MeshRays& rays, Crossings& found)
{
  TurnedPairs<8> pairs;
  for (std::size_t i = 0; i < rays.Count; ++i)
  {
    pairs.Set(i, { cells[i].Points, differences[i] }, rays.AxisOf(i));
  }
  pairs.FillUp(rays.Count);
  HWY_DYNAMIC_DISPATCH(HexahedronPairCrossingsOf)(pairs, rays, found);
}

}
}
#endif
