// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Passages/KernelsPassedCells.h"

#include <algorithm>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Passages/KernelsPassedCells.cxx"
#include <hwy/foreach_target.h>

#include "Beams/CellCubics-inl.h"
#include "Trace/KernelsSegment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace segments = SegmentKernels::HWY_NAMESPACE;

/// Which of a batch's segments the ray passes, and which it begins in, one bit each.
struct PassedPaths
{
  std::uint64_t Passed = 0, Begun = 0;
};

template <typename Real>
HWY_INLINE PassedPaths FindPassed(const SegmentBatch<Real>& in, const segments::Paths<Real>& paths)
{
  const hn::CappedTag<double, WidestVector / 2> d;
  PassedPaths found;
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.Count); i += hn::Lanes(d))
  {
    const auto enter = hn::LoadU(d, &in.Enter[i]), leave = hn::LoadU(d, &paths.Leave[i]);
    found.Passed |= BitsIn(d, hn::Lt(enter, leave)) << i;
    found.Begun |= BitsIn(d, hn::Le(enter, hn::LoadU(d, in.BeginOf() + i))) << i;
  }
  return found;
}

/// Refine the crossings of some vectors together, as the steps of each depend on those before.
template <std::size_t Together, typename Real>
HWY_INLINE void RefineTogether(const RayBatch::Array<Real> cubics[4], std::size_t i, Real* shares)
{
  using D = hn::CappedTag<Real, WidestVector>;
  using Steps = segments::Refinement<Real, D>;
  const D d;
  const auto all = hn::Eq(hn::Zero(d), hn::Zero(d));
  Steps roots[Together];
  for (std::size_t v = 0; v < Together; ++v)
  {
    hn::Vec<D> b[4];
    for (std::size_t c = 0; c < 4; ++c)
    {
      b[c] = hn::LoadU(d, &cubics[c][i + v * hn::Lanes(d)]);
    }
    roots[v].Begin(d, b, all);
  }
  bool areDone = false;
  for (int step = 0; step < Steps::MostSteps && !areDone; ++step)
  {
    areDone = true;
    for (Steps& root : roots)
    {
      root.Step(d);
      areDone = areDone && hn::AllFalse(d, root.Live);
    }
  }
  for (std::size_t v = 0; v < Together; ++v)
  {
    hn::StoreU(roots[v].S, d, shares + v * hn::Lanes(d));
  }
}

template <typename Real>
HWY_INLINE void FindAllPassed(SegmentBatch<Real>& in, bool isSolid, PassedCells& cells)
{
  const hn::CappedTag<Real, WidestVector> d;
  const std::size_t lanes = hn::Lanes(d), end = segments::FullVectors(in);
  segments::Paths<Real> paths;
  segments::SetUpPaths(in, end, paths);
  const PassedPaths passed = FindPassed(in, paths);
  RayBatch::Array<Real> cubics[4], shares;
  std::uint64_t any = 0, one = 0, begins = 0;
  const auto rising = hn::Set(d, Real(1)), falling = hn::Set(d, Real(-1));
  for (std::size_t i = 0; i < end; i += lanes)
  {
    hn::Vec<decltype(d)> b[4];
    segments::CubicsAlong(d, in, paths, i, b);
    const auto changes = segments::FindChanges(d, b);
    any |= BitsIn(d, changes.Any) << i;
    one |= BitsIn(d, changes.One) << i;
    begins |= BitsIn(d, changes.Begins) << i;
    for (std::size_t c = 0; c < 4; ++c)
    {
      // Others are not refined: a cubic whose root is found at once.
      hn::StoreU(hn::IfThenElse(changes.One, b[c], c < 2 ? falling : rising), d, &cubics[c][i]);
    }
  }
  std::size_t i = 0;
  for (; i + 4 * lanes <= end; i += 4 * lanes)
  {
    RefineTogether<4>(cubics, i, &shares[i]);
  }
  for (; i < end; i += lanes)
  {
    RefineTogether<1>(cubics, i, &shares[i]);
  }
  for (std::size_t at = 0; at < static_cast<std::size_t>(in.Count); ++at)
  {
    const double enter = in.Enter[at];
    cells.Distance[at] = enter + static_cast<double>(shares[at]) * (paths.Leave[at] - enter);
  }
  const std::uint64_t count = ~std::uint64_t(0) >> (RayBatch::Capacity - in.Count);
  any &= passed.Passed & count;
  // Where a ray begins in a cell, what is before that does not count.
  cells.Open = any & (~one | passed.Begun);
  cells.One = any & ~cells.Open & ~(isSolid ? begins : 0);
  cells.Exits = begins;
}

void PassedFloat(SegmentBatch<float>& segments, bool isSolid, PassedCells& cells)
{
  FindAllPassed(segments, isSolid, cells);
}

void PassedDouble(SegmentBatch<double>& segments, bool isSolid, PassedCells& cells)
{
  FindAllPassed(segments, isSolid, cells);
}

void FindWithin(const std::uint8_t* low, const std::uint8_t* high, std::size_t count,
  std::uint8_t key, std::uint64_t* words)
{
  const hn::CappedTag<std::uint8_t, 64> d;
  const auto wanted = hn::Set(d, key);
  const std::size_t lanes = hn::Lanes(d), whole = count / lanes * lanes;
  std::fill_n(words, (count + 63) / 64, std::uint64_t(0));
  for (std::size_t i = 0; i < whole; i += lanes)
  {
    const auto lowest = hn::LoadU(d, low + i), highest = hn::LoadU(d, high + i);
    const auto isWithin =
      hn::And(hn::Eq(hn::Min(lowest, wanted), lowest), hn::Eq(hn::Max(highest, wanted), highest));
    std::uint8_t bits[8] = { 0 };
    hn::StoreMaskBits(d, isWithin, bits);
    for (std::size_t byte = 0; byte < lanes / 8; ++byte)
    {
      words[i / 64] |= static_cast<std::uint64_t>(bits[byte]) << (i % 64 + 8 * byte);
    }
  }
  for (std::size_t i = whole; i < count; ++i)
  {
    words[i / 64] |= static_cast<std::uint64_t>(low[i] <= key && key <= high[i]) << i % 64;
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace BeamKernels
{
HWY_EXPORT(PassedFloat);
HWY_EXPORT(PassedDouble);
HWY_EXPORT(FindWithin);
}

void FindPassedSurfaces(SegmentBatch<float>& segments, bool isSolid, PassedCells& cells)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(PassedFloat)(segments, isSolid, cells);
}

void FindPassedSurfaces(SegmentBatch<double>& segments, bool isSolid, PassedCells& cells)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(PassedDouble)(segments, isSolid, cells);
}

void FindHolding(const std::uint8_t* low, const std::uint8_t* high, std::size_t count,
  std::uint8_t key, std::uint64_t* words)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(FindWithin)(low, high, count, key, words);
}

}
#endif
