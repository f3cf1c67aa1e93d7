// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rows of samples as they lie in memory, in vectors. Kernels include this file once for each kind
// of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsPacked_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsPacked_inl_h
#undef TemporalCoherence_KernelsPacked_inl_h
#else
#define TemporalCoherence_KernelsPacked_inl_h
#endif

#include "Scene/RayBatch.h"

#include <array>
#include <cstdint>
#include <type_traits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace PackedSamples
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Sample `Index` of the `Count` samples of `Bits` bits that are packed into 32-bit lanes, signed
/// if the lanes are.
template <int Bits, int Count, int Index, class V>
HWY_INLINE V Unpack(V words)
{
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  constexpr int Place = Count - 1 - Index;
#else
  constexpr int Place = Index;
#endif
  constexpr int Above = 32 - Bits * (Place + 1);
  return hn::ShiftRight<32 - Bits>(hn::ShiftLeft<Above>(words));
}

/// Rows of integers of up to 16 bits, unpacked to vectors of 32-bit lanes, one for each sample of
/// the row.
template <typename Stored>
struct IntegerRows
{
  using D = hn::CappedTag<float, WidestVector>;
  using Lane = std::conditional_t<std::is_signed_v<Stored>, std::int32_t, std::uint32_t>;
  using DW = hn::Rebind<Lane, D>;
  using V = hn::Vec<DW>;
  static constexpr int Bits = 8 * sizeof(Stored);

  HWY_INLINE static void Load(const std::array<Stored, 4>* rows, V out[4])
  {
    const DW dw;
    const auto* words = reinterpret_cast<const Lane*>(rows);
    if constexpr (sizeof(Stored) == 1)
    {
      const V all = hn::LoadU(dw, words);
      out[0] = Unpack<Bits, 4, 0>(all);
      out[1] = Unpack<Bits, 4, 1>(all);
      out[2] = Unpack<Bits, 4, 2>(all);
      out[3] = Unpack<Bits, 4, 3>(all);
    }
    else
    {
      V first, second;
      hn::LoadInterleaved2(dw, words, first, second);
      out[0] = Unpack<Bits, 2, 0>(first);
      out[1] = Unpack<Bits, 2, 1>(first);
      out[2] = Unpack<Bits, 2, 0>(second);
      out[3] = Unpack<Bits, 2, 1>(second);
    }
  }

  HWY_INLINE static void Load(const std::array<Stored, 2>* rows, V out[2])
  {
    const DW dw;
    V both;
    if constexpr (sizeof(Stored) == 1)
    {
      const hn::Rebind<hwy::MakeNarrow<Lane>, DW> dn;
      both = hn::PromoteTo(dw, hn::LoadU(dn, reinterpret_cast<const hwy::MakeNarrow<Lane>*>(rows)));
    }
    else
    {
      both = hn::LoadU(dw, reinterpret_cast<const Lane*>(rows));
    }
    out[0] = Unpack<Bits, 2, 0>(both);
    out[1] = Unpack<Bits, 2, 1>(both);
  }

  HWY_INLINE static hn::Vec<D> AsFloats(V samples)
  {
    const hn::Rebind<std::int32_t, D> di;
    return hn::ConvertTo(D(), hn::BitCast(di, samples));
  }
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
