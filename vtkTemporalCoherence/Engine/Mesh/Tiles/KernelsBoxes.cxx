// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Vectors of rays and one box.

#include "Mesh/Tiles/KernelsBoxes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Tiles/KernelsBoxes.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Where rays enter and leave a box, between WalkBegin and their limits.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void ClipToBox(D d, const RayBatch& rays, const RayBatch::Array<double>& limits,
  std::size_t i, const FloatBox& box, double margin, V& enter, V& leave)
{
  enter = hn::Load(d, &rays.WalkBegin[i]);
  leave = hn::Min(hn::Load(d, &rays.WalkEnd[i]), hn::Load(d, &limits[i]));
  // Where a ray runs along a face, its inverse is infinite. Its product with 0 would be NaN.
  const V largest = hn::Set(d, 1e300), smallest = hn::Set(d, -1e300);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<int>(a);
    const V origin = hn::Load(d, &rays.Origin[a][i]);
    const V inverse = hn::Max(hn::Min(hn::Load(d, &rays.Inverse[a][i]), largest), smallest);
    const V low =
      hn::Mul(hn::Sub(hn::Set(d, static_cast<double>(box.Low[axis]) - margin), origin), inverse);
    const V high =
      hn::Mul(hn::Sub(hn::Set(d, static_cast<double>(box.High[axis]) + margin), origin), inverse);
    enter = hn::Max(enter, hn::Min(low, high));
    leave = hn::Min(leave, hn::Max(low, high));
  }
}

template <class D>
HWY_INLINE std::uint64_t BitsOfLanes(D d, hn::Mask<D> mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, mask, bits);
  std::uint64_t lanes = 0;
  for (std::size_t byte = 0; byte < (hn::Lanes(d) + 7) / 8; ++byte)
  {
    lanes |= static_cast<std::uint64_t>(bits[byte]) << 8 * byte;
  }
  return lanes;
}

/// Bits of the rays in `which` that pass a test. Skips vectors without such a ray.
/// \param test called as test(tag, first ray)
template <class Test>
HWY_INLINE std::uint64_t FindRays(const RayBatch& rays, std::uint64_t which, const Test& test)
{
  const hn::ScalableTag<double> d;
  std::uint64_t found = 0;
  const std::uint64_t lanes = (std::uint64_t(1) << hn::Lanes(d)) - 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); i += hn::Lanes(d))
  {
    if ((which >> i & lanes) != 0)
    {
      found |= BitsOfLanes(d, test(d, i)) << i;
    }
  }
  return found & which;
}

std::uint64_t FindRaysThrough(const RayBatch& rays, std::uint64_t which,
  const RayBatch::Array<double>& limits, const FloatBox& box, double margin)
{
  return FindRays(rays, which,
    [&](auto d, std::size_t i) HWY_ATTR
    {
      hn::Vec<decltype(d)> enter, leave;
      ClipToBox(d, rays, limits, i, box, margin, enter, leave);
      return hn::Le(enter, leave);
    });
}

std::uint64_t FindRaysAcross(const RayBatch& rays, std::uint64_t which,
  const RayBatch::Array<double>& limits, const FloatBox& box, double margin,
  const NearlyLinear& differences)
{
  // Rounding moves points by up to the margin, and differences accordingly.
  const double most = differences.Bend + margin * glm::length(differences.Gradient);
  return FindRays(rays, which,
    [&](auto d, std::size_t i) HWY_ATTR
    {
      hn::Vec<decltype(d)> enter, leave;
      ClipToBox(d, rays, limits, i, box, margin, enter, leave);
      const auto bend = hn::Set(d, most);
      auto atOrigin = hn::Set(d, differences.AtZero), perT = hn::Zero(d);
      for (std::size_t a = 0; a < 3; ++a)
      {
        const auto slope = hn::Set(d, differences.Gradient[static_cast<int>(a)]);
        atOrigin = hn::MulAdd(slope, hn::Load(d, &rays.Origin[a][i]), atOrigin);
        perT = hn::MulAdd(slope, hn::Load(d, &rays.Direction[a][i]), perT);
      }
      const auto atEnter = hn::MulAdd(perT, enter, atOrigin);
      const auto atLeave = hn::MulAdd(perT, leave, atOrigin);
      const auto isAbove = hn::Gt(hn::Min(atEnter, atLeave), bend);
      const auto isBelow = hn::Lt(hn::Max(atEnter, atLeave), hn::Neg(bend));
      return hn::AndNot(hn::Or(isAbove, isBelow), hn::Le(enter, leave));
    });
}

std::uint64_t FindRaysReaching(
  const RayBatch& rays, std::uint64_t which, const RayBatch::Array<double>& limits, double depth)
{
  return FindRays(rays, which,
    [&](auto d, std::size_t i) HWY_ATTR
    {
      const auto at = hn::Mul(hn::Set(d, depth), hn::Load(d, &rays.PerDepth[i]));
      return hn::Le(at, hn::Load(d, &limits[i]));
    });
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindRaysAcross);
HWY_EXPORT(FindRaysReaching);
HWY_EXPORT(FindRaysThrough);

std::uint64_t RaysAcross(const RayBatch& rays, std::uint64_t which,
  const RayBatch::Array<double>& limits, const FloatBox& box, double margin,
  const NearlyLinear& differences)
{
  return HWY_DYNAMIC_DISPATCH(FindRaysAcross)(rays, which, limits, box, margin, differences);
}

std::uint64_t RaysReaching(
  const RayBatch& rays, std::uint64_t which, const RayBatch::Array<double>& limits, double depth)
{
  return HWY_DYNAMIC_DISPATCH(FindRaysReaching)(rays, which, limits, depth);
}

std::uint64_t RaysThrough(const RayBatch& rays, std::uint64_t which,
  const RayBatch::Array<double>& limits, const FloatBox& box, double margin)
{
  return HWY_DYNAMIC_DISPATCH(FindRaysThrough)(rays, which, limits, box, margin);
}

}
#endif
