// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The largest samples of cells. Kernels include this file once for each kind of vectors, hence the
// toggling guard.
#if defined(TemporalCoherence_KernelsLeafBounds_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsLeafBounds_inl_h
#undef TemporalCoherence_KernelsLeafBounds_inl_h
#else
#define TemporalCoherence_KernelsLeafBounds_inl_h
#endif

#include "Lattice/CellCubics-inl.h"
#include "Volumes/Projections/ExtremeBlocks.h"

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

/// Store numbers as floats, rounded up.
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

/// The smallest and the largest sample of each cell of a leaf, including cells beyond the field.
template <typename Real>
struct alignas(64) CellEnds
{
  std::array<Real, 64> Smallest, Largest;
};

/// \param bounds get the largest samples, rounded up
template <typename Real>
HWY_INLINE void FindEnds(
  const ExtremeLeaf<Real>& leaf, CellEnds<Real>& ends, std::array<float, 64>& bounds)
{
  constexpr std::size_t cells = ValueRangePyramid::LeafSize, edge = ExtremeLeaf<Real>::Edge;
  const hn::CappedTag<Real, cells> d;
  using Vector = hn::Vec<decltype(d)>;
  for (std::size_t x = 0; x < cells; x += hn::Lanes(d))
  {
    const Vector none = hn::Zero(d);
    Vector low[cells] = { none, none, none, none }, high[cells] = { none, none, none, none };
    for (std::size_t z = 0; z < edge; ++z)
    {
      Vector lowBefore = none, highBefore = none; // of the row before; above, of the plane before
      for (std::size_t y = 0; y < edge; ++y)
      {
        const Vector here = hn::LoadU(d, leaf.Row(y, z) + x);
        const Vector next = hn::LoadU(d, leaf.Row(y, z) + x + 1);
        const Vector lowRow = hn::Min(here, next), highRow = hn::Max(here, next);
        if (y > 0)
        {
          const Vector lowPlane = hn::Min(lowBefore, lowRow);
          const Vector highPlane = hn::Max(highBefore, highRow);
          if (z > 0)
          {
            const std::size_t cell = 16 * (z - 1) + 4 * (y - 1) + x;
            const Vector largest = hn::Max(high[y - 1], highPlane);
            hn::StoreU(hn::Min(low[y - 1], lowPlane), d, &ends.Smallest[cell]);
            hn::StoreU(largest, d, &ends.Largest[cell]);
            StoreRoundedUp(d, largest, &bounds[cell]);
          }
          low[y - 1] = lowPlane;
          high[y - 1] = highPlane;
        }
        lowBefore = lowRow;
        highBefore = highRow;
      }
    }
  }
}

/// Mask of the bounds from `least` on, without minus infinity.
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
