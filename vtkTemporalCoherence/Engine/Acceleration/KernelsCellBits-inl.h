// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Reading the bits of ActiveCells, in vectors. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsCellBits_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCellBits_inl_h
#undef TemporalCoherence_KernelsCellBits_inl_h
#else
#define TemporalCoherence_KernelsCellBits_inl_h
#endif

#include "Scene/RayBatch.h"

#include <hwy/highway.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using Words = hn::RebindToUnsigned<Doubles>;
using Integers = hn::RebindToSigned<Doubles>;
using V = hn::Vec<Doubles>;
using W = hn::Vec<Words>;
using I = hn::Vec<Integers>;
using M = hn::Mask<Doubles>;

/// Added to a whole number in [0, 2^52), it moves the number's bits to the double's lowest bits.
constexpr double ToBits = 4503599627370496.0;

HWY_INLINE W BitsOf(V whole)
{
  const Doubles d;
  return hn::BitCast(Words(), hn::Add(whole, hn::Set(d, ToBits)));
}

HWY_INLINE V WholeOf(W bits)
{
  const Doubles d;
  return hn::Sub(hn::BitCast(d, bits), hn::Set(d, ToBits));
}

/// Whole numbers in [0, 2^52) as positions in lists.
HWY_INLINE I IndexOf(V whole)
{
  const Words du;
  const W exponent = hn::BitCast(du, hn::Set(Doubles(), ToBits));
  return hn::BitCast(Integers(), hn::Xor(BitsOf(whole), exponent));
}

/// One bit for each lane.
HWY_INLINE std::uint64_t BitsOfMask(M mask)
{
  std::uint8_t bits[8] = { 0 };
  hn::StoreMaskBits(Doubles(), mask, bits);
  return bits[0];
}

/// x + 4 y + 16 z, where x, y and z are bits `from` and `from` + 1 of a cell's coordinates.
template <int from>
HWY_INLINE W PlaceOf(const W cell[3])
{
  const W lowestTwo = hn::Set(Words(), 3u);
  const W x = hn::And(hn::ShiftRight<from>(cell[0]), lowestTwo);
  const W y = hn::And(hn::ShiftRight<from>(cell[1]), lowestTwo);
  const W z = hn::And(hn::ShiftRight<from>(cell[2]), lowestTwo);
  return hn::Or(x, hn::Or(hn::ShiftLeft<2>(y), hn::ShiftLeft<4>(z)));
}

/// True where bit `place` of a word is 1.
HWY_INLINE M HasBit(W word, W place)
{
  const Words du;
  const W bit = hn::And(hn::Shr(word, place), hn::Set(du, 1u));
  return hn::RebindMask(Doubles(), hn::Ne(bit, hn::Zero(du)));
}

/// Gather words that other threads may be writing: one access reads each word.
HWY_INLINE W LoadShared(const std::atomic<std::uint64_t>* words, W at)
{
  const Words du;
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
  // The machine's gather reads each aligned word at once. C++ has no atomic gather, and eight
  // atomic loads in a row are measurably slower.
  static_assert(sizeof(std::atomic<std::uint64_t>) == sizeof(std::uint64_t) &&
      std::atomic<std::uint64_t>::is_always_lock_free,
    "an atomic word is a word");
  const auto* const plain = reinterpret_cast<const std::uint64_t*>(words);
  return hn::GatherIndex(du, plain, hn::BitCast(Integers(), at));
#else
  // Elsewhere Highway would gather by plain reads, which race with stores of other threads.
  const auto load = [words](std::uint64_t place) HWY_ATTR
  { return words[place].load(std::memory_order_relaxed); };
  constexpr std::size_t lanes = WidestVector / 2;
  std::uint64_t places[lanes];
  hn::StoreU(at, du, places);
  if (hn::Lanes(du) == 1)
  {
    return hn::Set(du, load(places[0]));
  }
  std::uint64_t loaded[lanes];
  for (std::size_t i = 0; i < hn::Lanes(du); ++i)
  {
    loaded[i] = load(places[i]);
  }
  return hn::LoadU(du, loaded);
#endif
}

}
}
HWY_AFTER_NAMESPACE();

#endif
