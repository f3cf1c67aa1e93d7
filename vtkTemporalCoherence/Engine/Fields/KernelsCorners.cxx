// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/KernelsCorners.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Fields/KernelsCorners.cxx"
#include <hwy/foreach_target.h>

#include "Scene/KernelsPacked-inl.h"

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

}
#endif
