// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The search for crossings in hexahedra, in vectors of boxes. Kernels include this file once for
// each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsRootSearch_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsRootSearch_inl_h
#undef TemporalCoherence_KernelsRootSearch_inl_h
#else
#define TemporalCoherence_KernelsRootSearch_inl_h
#endif

#include "Mesh/KernelsSeenFunctions-inl.h"
#include "Mesh/RootItems.h"

#include <algorithm>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// What is searched, and what was found.
struct RootWork
{
  const MeshRays& Rays;
  RootItems *Now, *Next;
  FoundRoots& Several;
  std::uint64_t Alone = 0;           ///< rays that have to be searched alone
  TileArray<std::uint8_t> CountOf{}; ///< boxes of each ray in Next

  HWY_INLINE void Push(
    std::size_t ray, const std::array<double, 3>& middle, const std::array<double, 3>& half)
  {
    if (this->CountOf[ray] == RootItems::MostOfRay)
    {
      this->Alone |= std::uint64_t(1) << ray;
      return;
    }
    ++this->CountOf[ray];
    RootItems& to = *this->Next;
    const std::size_t at = to.Count++;
    to.Ray[at] = static_cast<std::uint8_t>(ray);
    for (std::size_t a = 0; a < 3; ++a)
    {
      to.Middle[a][at] = middle[a];
      to.Half[a][at] = half[a];
    }
  }
};

/// A vector of boxes.
template <class D>
struct RootBoxes
{
  using V = hn::Vec<D>;
  static constexpr std::size_t Lanes = hn::MaxLanes(D());

  HWY_INLINE RootBoxes(const RootItems& items, std::size_t first)
    : Count(std::min(Lanes, items.Count - first))
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      HWY_ALIGN double middle[Lanes], half[Lanes];
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        const std::size_t at = first + std::min(lane, this->Count - 1);
        this->Ray[lane] = items.Ray[at];
        middle[lane] = items.Middle[a][at];
        half[lane] = items.Half[a][at];
      }
      this->Middle[a] = hn::Load(D(), middle);
      this->Half[a] = hn::Load(D(), half);
    }
  }

  /// Where lanes of the box lie in the cell.
  HWY_INLINE void ToCell(const V v[3], V at[3]) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      at[a] = hn::Add(this->Middle[a], hn::Mul(this->Half[a], v[a]));
    }
  }

  std::size_t Count;
  std::size_t Ray[Lanes];
  V Middle[3], Half[3];
};

/// Roots of lanes with one at most.
template <class D>
HWY_INLINE void AppendRoots(const NearlyLinear<D>& near, hn::Mask<D> lanes,
  const SeenFunctions<D>& seen, const RootBoxes<D>& boxes, bool isFirst, RootWork& work,
  Crossings& found)
{
  using V = hn::Vec<D>;
  constexpr std::size_t most = hn::MaxLanes(D());
  const D d;
  V v[3], at[3], rows[3][3], along[3];
  std::uint64_t left = BitsOf(d, near.Solve(lanes, v)) & ((std::uint64_t(1) << boxes.Count) - 1);
  if (left == 0)
  {
    return;
  }
  boxes.ToCell(v, at);
  GradientAt(seen.System[0], at, rows[0]);
  GradientAt(seen.System[1], at, rows[1]);
  GradientAt(seen.T, at, rows[2]);
  CrossRows(rows[0], rows[1], along);
  const V zero = hn::Zero(d);
  // The determinant has the same sign all over a box with one root at most.
  const std::uint64_t falling =
    BitsOf(d, hn::Xor(hn::Gt(near.Determinant, zero), hn::Gt(DotRows(along, rows[2]), zero)));
  HWY_ALIGN double t[most], places[3][most];
  hn::Store(hn::Add(ValueAt(seen.T, at), zero), d, t);
  for (std::size_t a = 0; a < 3; ++a)
  {
    hn::Store(at[a], d, places[a]);
  }
  for (; left != 0; left &= left - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
    const std::size_t ray = boxes.Ray[lane];
    const bool rises = (falling >> lane & 1u) == 0;
    if (!isFirst)
    {
      AddRoot({ { places[0][lane], places[1][lane], places[2][lane] }, t[lane], rises },
        work.Several.Begin(ray));
    }
    else if (t[lane] >= work.Rays.Begin[ray] && t[lane] <= work.Rays.End[ray])
    {
      found.Append(ray, t[lane], rises);
    }
  }
}

/// Look into boxes that are left: the part without known absence of roots, or its halves.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void PushBoxes(
  const RootBoxes<D>& boxes, const V low[3], const V high[3], std::uint64_t left, RootWork& work)
{
  constexpr std::size_t most = hn::MaxLanes(D());
  const D d;
  const V half = hn::Set(d, 0.5);
  HWY_ALIGN double parts[3][most], shares[3][most], middles[3][most], halves[3][most];
  for (std::size_t a = 0; a < 3; ++a)
  {
    hn::Store(hn::Mul(half, hn::Add(low[a], high[a])), d, parts[a]);
    hn::Store(hn::Mul(half, hn::Sub(high[a], low[a])), d, shares[a]);
    hn::Store(boxes.Middle[a], d, middles[a]);
    hn::Store(boxes.Half[a], d, halves[a]);
  }
  for (; left != 0; left &= left - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
    std::array<double, 3> part, share, box, edge;
    for (std::size_t a = 0; a < 3; ++a)
    {
      part[a] = parts[a][lane];
      share[a] = shares[a][lane];
      box[a] = middles[a][lane];
      edge[a] = halves[a][lane];
    }
    if (CutBox(part, share, box, edge))
    {
      work.Push(boxes.Ray[lane], box, edge);
      continue;
    }
    const auto longest =
      static_cast<std::size_t>(std::max_element(edge.begin(), edge.end()) - edge.begin());
    edge[longest] *= 0.5;
    box[longest] -= edge[longest];
    work.Push(boxes.Ray[lane], box, edge);
    box[longest] += 2.0 * edge[longest];
    work.Push(boxes.Ray[lane], box, edge);
  }
}

/// Look into a vector of boxes.
template <class D, class Functions>
HWY_INLINE void Look(const Functions& functions, const RootBoxes<D>& boxes, bool isFirst,
  RootWork& work, Crossings& found)
{
  using V = hn::Vec<D>;
  const D d;
  const SeenFunctions<D> seen(GatheredRays<D>(work.Rays, boxes.Ray), functions, boxes.Ray);
  const V one = hn::Set(d, 1.0), minusOne = hn::Set(d, -1.0), zero = hn::Zero(d);
  V local[3][8];
  auto isLeft = hn::Lt(zero, one);
  for (std::size_t i = 0; i < 3; ++i)
  {
    std::copy(seen.System[i], seen.System[i] + 8, local[i]);
    if (!isFirst)
    {
      Restrict(boxes.Middle, boxes.Half, local[i]);
    }
    const V error = hn::Mul(hn::Set(d, ValueError), seen.Largest[i]);
    isLeft = hn::And(isLeft, hn::Le(hn::Abs(local[i][0]), hn::Add(ReachOf(local[i]), error)));
  }
  if (hn::AllFalse(d, isLeft))
  {
    return;
  }
  const NearlyLinear<D> near(local, seen.Largest);
  V rest[3], steepest, low[3], high[3];
  near.Bound(rest, steepest);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const V reach = Three(rest[a], near.Error[a], hn::Set(d, Margin));
    low[a] = hn::Max(hn::Neg(hn::Add(near.Parts[a][0], reach)), minusOne);
    high[a] = hn::Min(hn::Sub(reach, near.Parts[a][0]), one);
    isLeft = hn::AndNot(hn::And(near.IsRegular, hn::Gt(low[a], high[a])), isLeft);
    low[a] = hn::IfThenElse(near.IsRegular, low[a], minusOne);
    high[a] = hn::IfThenElse(near.IsRegular, high[a], one);
  }
  const V error = LargestOf(near.Error[0], near.Error[1], near.Error[2]);
  const auto isWell = hn::And(near.IsRegular, hn::Lt(error, hn::Set(d, MostError)));
  const auto isOnly = hn::And(isLeft, hn::And(isWell, hn::Lt(steepest, hn::Set(d, MostNonlinear))));
  if (!hn::AllFalse(d, isOnly))
  {
    AppendRoots(near, isOnly, seen, boxes, isFirst, work, found);
  }
  const std::uint64_t left =
    BitsOf(d, hn::AndNot(isOnly, isLeft)) & ((std::uint64_t(1) << boxes.Count) - 1);
  if (left != 0)
  {
    PushBoxes(boxes, low, high, left, work);
  }
}

/// Look into ever smaller boxes, for all rays together.
template <class D, class Functions>
HWY_INLINE void LookRoundByRound(const Functions& functions, RootWork& work, Crossings& found)
{
  for (int round = 0; round < MostRounds && work.Now->Count > 0; ++round)
  {
    work.Next->Count = 0;
    work.CountOf.fill(0);
    for (std::size_t i = 0; i < work.Now->Count; i += hn::Lanes(D()))
    {
      Look(functions, RootBoxes<D>(*work.Now, i), round == 0, work, found);
    }
    // Rays that are searched alone are not searched here any more.
    RootItems& next = *work.Next;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < next.Count && work.Alone != 0; ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        next.Middle[a][kept] = next.Middle[a][i];
        next.Half[a][kept] = next.Half[a][i];
      }
      next.Ray[kept] = next.Ray[i];
      kept += (work.Alone >> next.Ray[i] & 1u) == 0;
    }
    next.Count = work.Alone != 0 ? kept : next.Count;
    std::swap(work.Now, work.Next);
  }
  for (std::size_t i = 0; i < work.Now->Count; ++i)
  {
    work.Alone |= std::uint64_t(1) << work.Now->Ray[i];
  }
}

/// Add a box for each ray that may meet a surface in its cell.
template <class D, class Functions>
HWY_INLINE void PushMet(const Functions& functions, const MeshRays& rays, std::size_t i,
  std::uint64_t wanted, RootWork& work)
{
  using V = hn::Vec<D>;
  const D d;
  std::size_t ray[hn::MaxLanes(D())];
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
  {
    ray[lane] = i + lane;
  }
  const ShearedRays<D> vector(rays, i);
  const SeenFunctions<D> seen(vector, functions, ray);
  auto isMet = hn::Lt(hn::Zero(d), hn::Set(d, 1.0));
  for (std::size_t f = 0; f < 2; ++f)
  {
    const V error = hn::Mul(hn::Set(d, ValueError), seen.Largest[f]);
    isMet =
      hn::And(isMet, hn::Le(hn::Abs(seen.System[f][0]), hn::Add(ReachOf(seen.System[f]), error)));
  }
  const V reach = hn::Add(ReachOf(seen.T), hn::Mul(hn::Set(d, Margin), hn::Abs(seen.T[0])));
  isMet = hn::And(isMet, hn::Le(hn::Sub(seen.T[0], hn::Add(reach, reach)), vector.End));
  isMet = hn::And(isMet, hn::Ge(hn::Add(seen.T[0], hn::Add(reach, reach)), vector.Begin));
  constexpr std::array<double, 3> middle{}, half = { 1.0, 1.0, 1.0 };
  for (wanted &= BitsOf(d, isMet); wanted != 0; wanted &= wanted - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(wanted));
    work.Push(i + lane, middle, half);
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
