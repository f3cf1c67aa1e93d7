// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Vectors of rays and one box.

#include "MeshFields/KernelsBoxes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "MeshFields/KernelsBoxes.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

std::uint64_t FindRaysThrough(
  const RayBatch& rays, const RayBatch::Array<double>& limits, const FloatBox& box, double margin)
{
  const hn::ScalableTag<double> d;
  // Where a ray runs along a face, its inverse is infinite. A product with 0 would be no number.
  const auto largest = hn::Set(d, 1e300), smallest = hn::Set(d, -1e300);
  std::uint64_t passing = 0;
  const auto count = static_cast<std::size_t>(rays.Count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    auto enter = hn::Load(d, &rays.WalkBegin[i]);
    auto leave = hn::Min(hn::Load(d, &rays.WalkEnd[i]), hn::Load(d, &limits[i]));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<int>(a);
      const auto origin = hn::Load(d, &rays.Origin[a][i]);
      const auto inverse = hn::Max(hn::Min(hn::Load(d, &rays.Inverse[a][i]), largest), smallest);
      const auto low =
        hn::Mul(hn::Sub(hn::Set(d, static_cast<double>(box.Low[axis]) - margin), origin), inverse);
      const auto high =
        hn::Mul(hn::Sub(hn::Set(d, static_cast<double>(box.High[axis]) + margin), origin), inverse);
      enter = hn::Max(enter, hn::Min(low, high));
      leave = hn::Min(leave, hn::Max(low, high));
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Le(enter, leave), bits);
    std::uint64_t ofVector = 0;
    for (std::size_t byte = 0; byte < (hn::Lanes(d) + 7) / 8; ++byte)
    {
      ofVector |= static_cast<std::uint64_t>(bits[byte]) << 8 * byte;
    }
    passing |= ofVector << i;
  }
  return count < 64 ? passing & ((std::uint64_t(1) << count) - 1) : passing;
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindRaysThrough);

std::uint64_t RaysThrough(
  const RayBatch& rays, const RayBatch::Array<double>& limits, const FloatBox& box, double margin)
{
  return HWY_DYNAMIC_DISPATCH(FindRaysThrough)(rays, limits, box, margin);
}

}
#endif
