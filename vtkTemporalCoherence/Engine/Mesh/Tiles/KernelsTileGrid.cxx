// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Finds the boxes that a tile can see, in vectors of boxes.

#include "Mesh/Tiles/KernelsTileGrid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Tiles/KernelsTileGrid.cxx"
#include <hwy/foreach_target.h>

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

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindBoxesWithin);

std::uint64_t BoxesWithin(const TilePlanes& planes, const BoxLanes& boxes)
{
  return HWY_DYNAMIC_DISPATCH(FindBoxesWithin)(planes, boxes);
}

}
#endif
