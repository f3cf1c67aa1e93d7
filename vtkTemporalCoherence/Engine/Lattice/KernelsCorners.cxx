// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsCorners.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsCorners.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsPacked-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace CornerKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

template <typename T>
HWY_INLINE void Subtract(const CornerPairs<T>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners)
{
  using Rows = PackedSamples::HWY_NAMESPACE::IntegerRows<T>;
  const typename Rows::D d;
  const auto first = hn::Set(d, high), second = hn::Set(d, low);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    for (std::size_t row = 0; row < 4; ++row)
    {
      typename Rows::V samples[2];
      Rows::Load(&pairs[row][i], samples);
      for (std::size_t x = 0; x < 2; ++x)
      {
        const auto difference = hn::Sub(hn::Sub(Rows::AsFloats(samples[x]), first), second);
        hn::StoreU(difference, d, &corners[2 * row + x][i]);
      }
    }
  }
}

template <typename T>
HWY_INLINE bool Gather(const NarrowSamples<T>& samples, const CellColumns& cells, int samplesAlongX,
  float high, float low, CornerColumns<float>& corners)
{
  using Rows = PackedSamples::HWY_NAMESPACE::GatheredRows<T>;
  const typename Rows::D d;
  const typename Rows::Places di;
  const auto first = hn::Set(d, high), second = hn::Set(d, low);
  if constexpr (sizeof(T) == 1)
  {
    // Gathers of bytes also read one sample before and one behind each pair.
    auto isOuter = hn::Lt(hn::Zero(di), hn::Zero(di));
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(d))
    {
      const auto x = hn::LoadU(di, &cells[0][i]);
      const auto isLast = hn::Gt(x, hn::Set(di, samplesAlongX - 3));
      isOuter = hn::Or(isOuter, hn::Or(hn::Eq(x, hn::Zero(di)), isLast));
    }
    if (!hn::AllFalse(di, isOuter))
    {
      return false;
    }
  }
  for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(d))
  {
    const hn::Vec<decltype(di)> cell[3] = { hn::LoadU(di, &cells[0][i]),
      hn::LoadU(di, &cells[1][i]), hn::LoadU(di, &cells[2][i]) };
    const Rows rows(samples, cell);
    for (int row = 0; row < 4; ++row)
    {
      typename Rows::V pair[2];
      rows.Two(row & 1, row >> 1, pair);
      for (int x = 0; x < 2; ++x)
      {
        const auto difference = hn::Sub(hn::Sub(Rows::AsFloats(pair[x]), first), second);
        hn::StoreU(difference, d, &corners[static_cast<std::size_t>(2 * row + x)][i]);
      }
    }
  }
  return true;
}

bool GatherUInt8(const NarrowSamples<std::uint8_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners)
{
  return Gather(samples, cells, samplesAlongX, high, low, corners);
}

bool GatherInt8(const NarrowSamples<std::int8_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners)
{
  return Gather(samples, cells, samplesAlongX, high, low, corners);
}

bool GatherUInt16(const NarrowSamples<std::uint16_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners)
{
  return Gather(samples, cells, samplesAlongX, high, low, corners);
}

bool GatherInt16(const NarrowSamples<std::int16_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners)
{
  return Gather(samples, cells, samplesAlongX, high, low, corners);
}

void SubtractUInt8(const CornerPairs<std::uint8_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners)
{
  Subtract(pairs, count, high, low, corners);
}

void SubtractInt8(const CornerPairs<std::int8_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners)
{
  Subtract(pairs, count, high, low, corners);
}

void SubtractUInt16(const CornerPairs<std::uint16_t>& pairs, std::size_t count, float high,
  float low, CornerColumns<float>& corners)
{
  Subtract(pairs, count, high, low, corners);
}

void SubtractInt16(const CornerPairs<std::int16_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners)
{
  Subtract(pairs, count, high, low, corners);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace CornerKernels
{
HWY_EXPORT(SubtractUInt8);
HWY_EXPORT(SubtractInt8);
HWY_EXPORT(SubtractUInt16);
HWY_EXPORT(SubtractInt16);
HWY_EXPORT(GatherUInt8);
HWY_EXPORT(GatherInt8);
HWY_EXPORT(GatherUInt16);
HWY_EXPORT(GatherInt16);
}

using namespace CornerKernels;

void SubtractFrom(const CornerPairs<std::uint8_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners)
{
  HWY_DYNAMIC_DISPATCH(SubtractUInt8)(pairs, count, high, low, corners);
}

void SubtractFrom(const CornerPairs<std::int8_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners)
{
  HWY_DYNAMIC_DISPATCH(SubtractInt8)(pairs, count, high, low, corners);
}

void SubtractFrom(const CornerPairs<std::uint16_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners)
{
  HWY_DYNAMIC_DISPATCH(SubtractUInt16)(pairs, count, high, low, corners);
}

void SubtractFrom(const CornerPairs<std::int16_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners)
{
  HWY_DYNAMIC_DISPATCH(SubtractInt16)(pairs, count, high, low, corners);
}

bool GatherDifferences(const NarrowSamples<std::uint8_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners)
{
  return HWY_DYNAMIC_DISPATCH(GatherUInt8)(samples, cells, samplesAlongX, high, low, corners);
}

bool GatherDifferences(const NarrowSamples<std::int8_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners)
{
  return HWY_DYNAMIC_DISPATCH(GatherInt8)(samples, cells, samplesAlongX, high, low, corners);
}

bool GatherDifferences(const NarrowSamples<std::uint16_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners)
{
  return HWY_DYNAMIC_DISPATCH(GatherUInt16)(samples, cells, samplesAlongX, high, low, corners);
}

bool GatherDifferences(const NarrowSamples<std::int16_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners)
{
  return HWY_DYNAMIC_DISPATCH(GatherInt16)(samples, cells, samplesAlongX, high, low, corners);
}

}
#endif
