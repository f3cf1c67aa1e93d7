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

#include "Scene/Field.h"
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

/// Rows of a vector of cells, gathered directly from memory.
template <typename T>
struct GatheredRows : IntegerRows<T>
{
  using typename IntegerRows<T>::V;
  using typename IntegerRows<T>::DW;
  using Places = hn::Rebind<std::int32_t, typename IntegerRows<T>::D>;

  /// \param cell first corners, by axis
  HWY_INLINE GatheredRows(const NarrowSamples<T>& samples, const hn::Vec<Places> cell[3])
    : From(samples)
  {
    const Places d;
    constexpr auto bytes = static_cast<std::int32_t>(sizeof(T));
    const auto times = [&](hn::Vec<Places> place, std::int32_t stride) HWY_ATTR
    { return hn::Mul(place, hn::Set(d, bytes * stride)); };
    this->Cell = hn::Add(
      hn::Add(times(cell[0], 1), times(cell[1], samples.StrideY)), times(cell[2], samples.StrideZ));
  }

  /// Four samples of the row y rows and z slices away from the first corner: the cell's two
  /// samples, and one neighbour at each side.
  HWY_INLINE void Four(int y, int z, V out[4]) const
  {
    const std::int32_t first = this->OffsetOf(y, z) - 1;
    if constexpr (sizeof(T) == 1)
    {
      const V all = this->Words(first);
      out[0] = Unpack<8, 4, 0>(all);
      out[1] = Unpack<8, 4, 1>(all);
      out[2] = Unpack<8, 4, 2>(all);
      out[3] = Unpack<8, 4, 3>(all);
    }
    else
    {
      const V low = this->Words(first), high = this->Words(first + 2);
      out[0] = Unpack<16, 2, 0>(low);
      out[1] = Unpack<16, 2, 1>(low);
      out[2] = Unpack<16, 2, 0>(high);
      out[3] = Unpack<16, 2, 1>(high);
    }
  }

  /// The cell's two samples of that row. Byte samples are read together with both neighbours.
  HWY_INLINE void Two(int y, int z, V out[2]) const
  {
    const std::int32_t first = this->OffsetOf(y, z);
    if constexpr (sizeof(T) == 1)
    {
      const V all = this->Words(first - 1);
      out[0] = Unpack<8, 4, 1>(all);
      out[1] = Unpack<8, 4, 2>(all);
    }
    else
    {
      const V both = this->Words(first);
      out[0] = Unpack<16, 2, 0>(both);
      out[1] = Unpack<16, 2, 1>(both);
    }
  }

private:
  HWY_INLINE std::int32_t OffsetOf(int y, int z) const
  {
    return y * this->From.StrideY + z * this->From.StrideZ;
  }

  /// 32 bits from a sample of each cell on.
  HWY_INLINE V Words(std::int32_t offset) const
  {
    const auto* const base = reinterpret_cast<const std::int32_t*>(this->From.Samples + offset);
    return hn::BitCast(DW(), hn::GatherOffset(Places(), base, this->Cell));
  }

  const NarrowSamples<T>& From;
  hn::Vec<Places> Cell; ///< in bytes from the first sample
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
