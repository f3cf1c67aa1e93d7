// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The largest samples of cells.
// Included by kernels once for each kind of vectors, hence the guard that turns over.
#if defined(TemporalCoherence_KernelsLeafBounds_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsLeafBounds_inl_h
#undef TemporalCoherence_KernelsLeafBounds_inl_h
#else
#define TemporalCoherence_KernelsLeafBounds_inl_h
#endif

#include "Beams/CellCubics-inl.h"
#include "Projections/ExtremeBlocks.h"

#include <algorithm>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ExtremeKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace beams = BeamKernels::HWY_NAMESPACE;

/// Store numbers as floats that are not less.
template <class D, class Vector = hn::Vec<D>>
HWY_INLINE void StoreRoundedUp(D d, Vector values, float* to)
{
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(float))
  {
    hn::StoreU(values, d, to);
  }
  else
  {
    const hn::Rebind<float, D> df;
    const Vector bounded = hn::Max(values, hn::Set(d, -3e38));
    const auto isLess = hn::Lt(hn::PromoteTo(d, hn::DemoteTo(df, bounded)), bounded);
    const Vector more =
      hn::MulAdd(hn::Abs(bounded), hn::Set(d, 0x1p-22), hn::Add(bounded, hn::Set(d, 1e-37)));
    hn::StoreU(hn::DemoteTo(df, hn::IfThenElse(isLess, more, bounded)), df, to);
  }
}

/// Bounds of the samples of each cell of a leaf, whether or not the cell is there.
template <typename Real>
HWY_INLINE void BoundCells(const ExtremeLeaf<Real>& leaf, std::array<float, 64>& bounds)
{
  constexpr std::size_t cells = ValueRangePyramid::LeafSize, edge = ExtremeLeaf<Real>::Edge;
  const hn::CappedTag<Real, cells> d;
  using Vector = hn::Vec<decltype(d)>;
  for (std::size_t x = 0; x < cells; x += hn::Lanes(d))
  {
    const Vector none = hn::Zero(d);
    Vector before[cells] = { none, none, none, none }; // of the plane before
    for (std::size_t z = 0; z < edge; ++z)
    {
      Vector rowBefore = none;
      for (std::size_t y = 0; y < edge; ++y)
      {
        const Real* const from = leaf.Row(y, z) + x;
        const Vector row = hn::Max(hn::LoadU(d, from), hn::LoadU(d, from + 1));
        if (y > 0)
        {
          const Vector plane = hn::Max(rowBefore, row);
          if (z > 0)
          {
            StoreRoundedUp(
              d, hn::Max(before[y - 1], plane), &bounds[16 * (z - 1) + 4 * (y - 1) + x]);
          }
          before[y - 1] = plane;
        }
        rowBefore = row;
      }
    }
  }
}

/// One bit for each of 64 bounds that is at least so much, and not minus infinity.
HWY_INLINE std::uint64_t FindAtLeast(const std::array<float, 64>& bounds, float least)
{
  const auto threshold = beams::Set(std::max(least, std::numeric_limits<float>::lowest()));
  std::uint64_t found = 0;
  for (std::size_t i = 0; i < bounds.size(); i += hn::Lanes(beams::Floats()))
  {
    found |= beams::BitsOf(hn::Ge(beams::Load(&bounds[i]), threshold)) << i;
  }
  return found;
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
