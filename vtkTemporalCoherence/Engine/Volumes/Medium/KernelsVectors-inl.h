// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The vectors of the kernels of emission.
// Kernels include this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsVectors_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsVectors_inl_h
#undef TemporalCoherence_KernelsVectors_inl_h
#else
#define TemporalCoherence_KernelsVectors_inl_h
#endif

#include "Scene/RayBatch.h"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WidestVector>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using V = hn::Vec<Floats>;
using I = hn::Vec<Integers>;
using M = hn::Mask<Floats>;

#if HWY_HAVE_SCALABLE || HWY_TARGET == HWY_SCALAR

/// Load four adjacent floats for each lane. out[i] gets number i of each four.
/// \param places offset in `from` for each lane
HWY_INLINE void LoadRows(const float* from, const std::int32_t* places, V out[4])
{
  HWY_ALIGN float all[4 * WidestVector];
  for (std::size_t lane = 0; lane < hn::Lanes(Floats()); ++lane)
  {
    std::memcpy(all + 4 * lane, from + places[lane], 4 * sizeof(float));
  }
  hn::LoadInterleaved4(Floats(), all, out[0], out[1], out[2], out[3]);
}

#else

/// Load a vector whose blocks of four lanes lie at places[0], places[4] and so on.
template <class D>
HWY_INLINE hn::Vec<D> LoadBlocks(D d, const float* from, const std::int32_t* places)
{
  if constexpr (hn::MaxLanes(D()) <= 4)
  {
    return hn::LoadU(d, from + places[0]);
  }
  else
  {
    const hn::Half<D> half;
    return hn::Combine(
      d, LoadBlocks(half, from, places + hn::MaxLanes(half)), LoadBlocks(half, from, places));
  }
}

/// Load four adjacent floats for each lane. out[i] gets number i of each four. Loading and
/// transposing rows is faster than gathering.
/// \param places offset in `from` for each lane
HWY_INLINE void LoadRows(const float* from, const std::int32_t* places, V out[4])
{
  const Floats d;
  const hn::Repartition<double, Floats> pairs;
  const V r[4] = { LoadBlocks(d, from, places), LoadBlocks(d, from, places + 1),
    LoadBlocks(d, from, places + 2), LoadBlocks(d, from, places + 3) };
  const auto xy = hn::BitCast(pairs, hn::InterleaveLower(r[0], r[1]));
  const auto xyNext = hn::BitCast(pairs, hn::InterleaveLower(r[2], r[3]));
  const auto zw = hn::BitCast(pairs, hn::InterleaveUpper(d, r[0], r[1]));
  const auto zwNext = hn::BitCast(pairs, hn::InterleaveUpper(d, r[2], r[3]));
  out[0] = hn::BitCast(d, hn::InterleaveLower(xy, xyNext));
  out[1] = hn::BitCast(d, hn::InterleaveUpper(pairs, xy, xyNext));
  out[2] = hn::BitCast(d, hn::InterleaveLower(zw, zwNext));
  out[3] = hn::BitCast(d, hn::InterleaveUpper(pairs, zw, zwNext));
}

#endif

}
}
}
HWY_AFTER_NAMESPACE();

#endif
