// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What a tile can see, in vectors of boxes and of points.

#include "MeshTiles/KernelsTileGrid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "MeshTiles/KernelsTileGrid.cxx"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

std::uint64_t FindBoxesWithin(const TilePlanes& planes, const BoxLanes& boxes)
{
  const hn::CappedTag<float, 16> d;
  const auto zero = hn::Zero(d);
  std::uint64_t within = 0;
  for (std::size_t i = 0; i < 64; i += hn::Lanes(d))
  {
    auto isWithin = hn::Ge(hn::Load(d, &boxes.Half[0][i]), zero);
    for (std::size_t plane = 0; plane < 4; ++plane)
    {
      auto sum = hn::Set(d, planes.Offset[plane]);
      for (std::size_t a = 0; a < 3; ++a)
      {
        const auto normal = hn::Set(d, planes.Normal[a][plane]);
        sum = hn::MulAdd(normal, hn::Load(d, &boxes.Middle[a][i]), sum);
        sum = hn::MulAdd(hn::Abs(normal), hn::Load(d, &boxes.Half[a][i]), sum);
      }
      isWithin = hn::And(isWithin, hn::Ge(sum, zero));
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, isWithin, bits);
    const std::uint64_t lanes = bits[0] | static_cast<std::uint64_t>(bits[1]) << 8;
    within |= lanes << i;
  }
  return within;
}

/// Bits of the pixels of a row of a tile between two coordinates.
HWY_INLINE std::uint64_t BitsBetween(double low, double high)
{
  // Moved above 0, where conversion rounds down.
  const int from = static_cast<int>(9.0 - std::min(std::max(-0.5, low), 8.0));  // 9 - ceil(low)
  const int last = static_cast<int>(std::max(std::min(7.0, high), -1.0) + 1.0); // floor(high) + 1
  const int first = 9 - from;
  return first >= last ? 0 : ((std::uint64_t(1) << last) - 1) & ~((std::uint64_t(1) << first) - 1);
}

std::uint64_t FindPixelsAround(const TileRows& rows, const PointLanes& points, int count)
{
  const hn::CappedTag<double, 8> d;
  const auto one = hn::Set(d, 1.0);
  auto lowX = hn::Set(d, 1e30), highX = hn::Set(d, -1e30), lowY = lowX, highY = highX;
  auto isBehind = hn::Lt(one, hn::Zero(d));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += hn::Lanes(d))
  {
    const auto x = hn::Sub(hn::LoadU(d, &points[0][i]), hn::Set(d, rows.Origin.x));
    const auto y = hn::Sub(hn::LoadU(d, &points[1][i]), hn::Set(d, rows.Origin.y));
    const auto z = hn::Sub(hn::LoadU(d, &points[2][i]), hn::Set(d, rows.Origin.z));
    const auto along = [&](const glm::dvec3& row) HWY_ATTR
    {
      return hn::MulAdd(
        x, hn::Set(d, row.x), hn::MulAdd(y, hn::Set(d, row.y), hn::Mul(z, hn::Set(d, row.z))));
    };
    auto perDepth = one;
    if (rows.IsPerspective)
    {
      const auto depth = along(rows.Row[0]);
      isBehind = hn::Or(isBehind, hn::Not(hn::Gt(depth, hn::Zero(d))));
      perDepth = hn::Div(one, depth);
    }
    const auto column = hn::Mul(along(rows.Row[1]), perDepth);
    const auto row = hn::Mul(along(rows.Row[2]), perDepth);
    lowX = hn::Min(lowX, column);
    highX = hn::Max(highX, column);
    lowY = hn::Min(lowY, row);
    highY = hn::Max(highY, row);
  }
  if (!hn::AllFalse(d, isBehind))
  {
    return ~std::uint64_t(0); // beside the eye or behind it
  }
  const std::uint64_t columns = BitsBetween(hn::GetLane(hn::MinOfLanes(d, lowX)) - rows.Margin,
    hn::GetLane(hn::MaxOfLanes(d, highX)) + rows.Margin);
  const std::uint64_t lines = BitsBetween(hn::GetLane(hn::MinOfLanes(d, lowY)) - rows.Margin,
    hn::GetLane(hn::MaxOfLanes(d, highY)) + rows.Margin);
  // Spread the bits of the rows over bytes (seven by one product), and fill these with the columns.
  const std::uint64_t spread =
    ((lines & 0x7f) * 0x0002040810204081u & 0x0101010101010101u) | lines >> 7 << 56;
  return spread * columns;
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindBoxesWithin);
HWY_EXPORT(FindPixelsAround);

std::uint64_t BoxesWithin(const TilePlanes& planes, const BoxLanes& boxes)
{
  return HWY_DYNAMIC_DISPATCH(FindBoxesWithin)(planes, boxes);
}

std::uint64_t PixelsAround(const TileRows& rows, const PointLanes& points, int count)
{
  return HWY_DYNAMIC_DISPATCH(FindPixelsAround)(rows, points, count);
}

}
#endif
