// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsCrossing.h"

#include "Lattice/CellRoot.h"
#include "Lattice/CellSegment.h"

#include <limits>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsCrossing.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsSegment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace SegmentKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Markers in lanes without a share of the path, which would lie in [0, 1].
constexpr int NoCrossing = -1;
constexpr int SeveralChanges = -2;

/// Finds the shares of a vector of paths at which they cross zero.
template <typename Real>
struct ShareSearch
{
  using D = hn::CappedTag<Real, WidestVector>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  HWY_INLINE void Begin(
    SegmentBatch<Real>& segments, const Paths<Real>& paths, bool isSolid, std::size_t i)
  {
    const D d;
    const V zero = hn::Zero(d);
    V b[4];
    CubicsAlong(d, segments, paths, i, b);
    const SignChanges<M> changes = FindChanges(d, b);
    const M begins = isSolid ? changes.Begins : hn::Lt(zero, zero);
    this->Several = hn::AndNot(begins, hn::AndNot(changes.One, changes.Any));
    this->One = hn::AndNot(begins, changes.One);
    const V unknown =
      hn::IfThenElse(changes.Any, hn::Set(d, Real(SeveralChanges)), hn::Set(d, Real(NoCrossing)));
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

/// Search several vectors interleaved: the steps of each vector form a dependency chain.
/// \param from first segment of each vector
/// \return lanes that must be searched one by one
template <std::size_t Together, typename Real, class Search = ShareSearch<Real>>
HWY_INLINE typename Search::M FindSharesOf(SegmentBatch<Real>& segments, const Paths<Real>& paths,
  bool isSolid, const std::size_t* from, Real* shares)
{
  const typename Search::D d;
  Search all[Together];
  auto several = hn::Lt(hn::Zero(d), hn::Zero(d));
  for (std::size_t v = 0; v < Together; ++v)
  {
    all[v].Begin(segments, paths, isSolid, from[v]);
    several = hn::Or(several, all[v].Several);
  }
  for (int step = 0; step < decltype(Search::Root)::MostSteps; ++step)
  {
    bool areDone = true;
    for (const Search& search : all)
    {
      areDone = areDone && search.IsDone();
    }
    if (areDone)
    {
      break;
    }
    for (Search& search : all)
    {
      search.Root.Step(d);
    }
  }
  for (std::size_t v = 0; v < Together; ++v)
  {
    hn::StoreU(all[v].Shares(), d, shares + from[v]);
  }
  return several;
}

/// \return true if some segments have to be searched one by one
template <typename Real>
HWY_INLINE bool FindShares(
  SegmentBatch<Real>& segments, const Paths<Real>& paths, bool isSolid, Real* shares)
{
  const typename ShareSearch<Real>::D d;
  constexpr std::size_t most = RayBatch::Capacity;
  std::size_t from[most], count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); i += hn::Lanes(d))
  {
    from[count] = i;
    count += IsAnyWanted(segments, i);
  }
  auto several = hn::Lt(hn::Zero(d), hn::Zero(d));
  std::size_t v = 0;
  for (; v + 4 <= count; v += 4)
  {
    several = hn::Or(several, FindSharesOf<4>(segments, paths, isSolid, from + v, shares));
  }
  for (; v + 2 <= count; v += 2)
  {
    several = hn::Or(several, FindSharesOf<2>(segments, paths, isSolid, from + v, shares));
  }
  for (; v < count; ++v)
  {
    several = hn::Or(several, FindSharesOf<1>(segments, paths, isSolid, from + v, shares));
  }
  return !hn::AllFalse(d, several);
}

/// Search segment i alone: its cubic has several sign changes.
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

template <bool AreBoxes = false, typename Real>
HWY_INLINE void FindAll(SegmentBatch<Real>& segments, bool isSolid)
{
  Paths<Real> paths;
  RayBatch::Array<Real> shares;
  SetUpPaths<AreBoxes>(segments, FullVectors(segments), paths);
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

void FindInBoxes(SegmentBatch<double>& segments, bool isSolid)
{
  FindAll<true>(segments, isSolid);
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

/// With fewer segments than this, scalar search is faster. Measured by `BenchmarkKernels`,
/// crossings.
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
HWY_EXPORT(FindInBoxes);
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

void FindCrossingsInBoxes(SegmentBatch<double>& segments, bool isSolid)
{
  using namespace SegmentKernels;
  HWY_DYNAMIC_DISPATCH(FindInBoxes)(segments, isSolid);
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
