// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Powers, in vectors. Kernels include this file once for each kind of vectors, hence the toggling
// guard.
#if defined(TemporalCoherence_KernelsPower_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsPower_inl_h
#undef TemporalCoherence_KernelsPower_inl_h
#else
#define TemporalCoherence_KernelsPower_inl_h
#endif

#include "Scene/RayBatch.h"

#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace Powers
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WidestVector>;

/// Raises numbers in [0, 1] to a power. 0 stays 0.
class Raiser
{
public:
  explicit Raiser(double power)
    : Power(static_cast<float>(power))
    , Whole(power == std::floor(power) && power >= 1.0 && power <= LargestWhole
          ? static_cast<int>(power)
          : 0)
  {
  }

  HWY_INLINE hn::Vec<Floats> operator()(hn::Vec<Floats> base) const
  {
    const Floats d;
    if (this->Whole == 0)
    {
      return this->RaiseOneByOne(base);
    }
    hn::Vec<Floats> result = hn::Set(d, 1.0f);
    for (int rest = this->Whole; rest > 0; rest >>= 1)
    {
      result = (rest & 1) != 0 ? hn::Mul(result, base) : result;
      base = hn::Mul(base, base);
    }
    return result;
  }

private:
  static constexpr double LargestWhole = 1024.0;

  hn::Vec<Floats> RaiseOneByOne(hn::Vec<Floats> base) const
  {
    const Floats d;
    std::array<float, WidestVector> values;
    hn::StoreU(base, d, values.data());
    for (std::size_t i = 0; i < hn::Lanes(d); ++i)
    {
      values[i] = values[i] > 0.0f ? std::pow(values[i], this->Power) : 0.0f;
    }
    return hn::LoadU(d, values.data());
  }

  float Power;
  int Whole; ///< the power if it is an integer that few multiplications reach; else 0
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
