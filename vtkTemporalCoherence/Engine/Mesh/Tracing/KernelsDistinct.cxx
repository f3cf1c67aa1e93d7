// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Finds the distinct cells of a tile's rays, in vectors of rays.

#include "Mesh/Tracing/KernelsDistinct.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Tracing/KernelsDistinct.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Numbers = hn::CappedTag<std::uint32_t, WidestVector>;

/// Bits of the rays that have this number.
HWY_INLINE std::uint64_t RaysWith(
  std::uint32_t number, const RayBatch::Array<std::uint32_t>& numbers)
{
  const Numbers d;
  const auto same = hn::Set(d, number);
  std::uint64_t rays = 0;
  for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(d))
  {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Eq(hn::Load(d, &numbers[i]), same), bits);
    rays |= (bits[0] | static_cast<std::uint64_t>(bits[1]) << 8) << i;
  }
  return rays;
}

void Distinguish(
  const RayBatch::Array<std::uint32_t>& numbers, std::uint64_t which, DistinctCells& distinct)
{
  distinct.Count = 0;
  while (which != 0)
  {
    const std::uint32_t number = numbers[hwy::Num0BitsBelowLS1Bit_Nonzero64(which)];
    const std::uint64_t rays = RaysWith(number, numbers) & which;
    distinct.Numbers[distinct.Count] = number;
    distinct.Rays[distinct.Count] = rays;
    ++distinct.Count;
    which &= ~rays;
  }
}

/// Insert four zero bits behind every two bits, up to the 32 bits of a rank.
template <class V>
HWY_INLINE V SpreadPairs(V x)
{
  const Numbers d;
  x = hn::And(hn::Or(x, hn::ShiftLeft<16>(x)), hn::Set(d, 0x0F0000FFu));
  x = hn::And(hn::Or(x, hn::ShiftLeft<8>(x)), hn::Set(d, 0x0F00F00Fu));
  return hn::And(hn::Or(x, hn::ShiftLeft<4>(x)), hn::Set(d, 0xC30C30C3u));
}

/// MeshLattice::NumberOf, in vectors.
void Rank(const RayCells& cells, RayBatch::Array<std::uint32_t>& ranks)
{
  const Numbers d;
  const hn::RebindToSigned<Numbers> di;
  for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(d))
  {
    const auto part = [&](std::size_t a) HWY_ATTR
    { return SpreadPairs(hn::BitCast(d, hn::Load(di, &cells.Cell[a][i]))); };
    const auto xy = hn::Or(part(0), hn::ShiftLeft<2>(part(1)));
    hn::Store(hn::Or(xy, hn::ShiftLeft<4>(part(2))), d, &ranks[i]);
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(Distinguish);
HWY_EXPORT(Rank);

void FindDistinct(
  const RayBatch::Array<std::uint32_t>& numbers, std::uint64_t which, DistinctCells& distinct)
{
  HWY_DYNAMIC_DISPATCH(Distinguish)(numbers, which, distinct);
}

void FindRanks(const RayCells& cells, RayBatch::Array<std::uint32_t>& ranks)
{
  HWY_DYNAMIC_DISPATCH(Rank)(cells, ranks);
}

}
#endif
