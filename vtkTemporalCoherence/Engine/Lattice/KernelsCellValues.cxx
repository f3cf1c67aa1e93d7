// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsCellValues.h"

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsCellValues.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsDifference-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 4>;
using V = hn::Vec<Doubles>;
constexpr std::size_t Corner = 8;

HWY_INLINE V AsDoubles(const double* samples)
{
  return hn::LoadU(Doubles(), samples);
}
HWY_INLINE V AsDoubles(const float* samples)
{
  return hn::PromoteTo(Doubles(), hn::LoadU(hn::Rebind<float, Doubles>(), samples));
}

/// Load a vector of samples from corner number `corner` on.
template <typename T>
HWY_INLINE V LoadCorners(const CellRows<T>& rows, std::size_t corner)
{
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(Doubles()) == 4)
  {
    const hn::FixedTag<T, 2> row;
    const hn::FixedTag<T, 4> both;
    const auto first = hn::LoadU(row, rows[corner / 2]);
    const auto samples = hn::Combine(both, hn::LoadU(row, rows[corner / 2 + 1]), first);
    if constexpr (sizeof(T) == sizeof(double))
    {
      return samples;
    }
    else
    {
      return hn::PromoteTo(Doubles(), samples);
    }
  }
  else
#endif
  {
    return AsDoubles(rows[corner / 2] + corner % 2);
  }
}

template <typename T>
HWY_INLINE void FindValues(const CellRows<T>& rows, const DifferenceInDouble& from, double unit,
  Corners<double>& corners, CellValues& values)
{
  const Doubles d;
  const hn::Rebind<float, Doubles> df;
  std::array<float, Corner> single;
  for (std::size_t corner = 0; corner < Corner; corner += hn::Lanes(d))
  {
    const V sample = LoadCorners(rows, corner);
    const V result = DifferenceKernels::HWY_NAMESPACE::Differ(d, from, sample);
    hn::StoreU(result, d, &corners[corner]);
    hn::StoreU(hn::DemoteTo(df, hn::Mul(result, hn::Set(d, unit))), df, &single[corner]);
  }
  for (std::size_t row = 0; row < 4; ++row)
  {
    values.Set(row, single[2 * row], single[2 * row + 1]);
  }
}

void ValuesOfFloat(const CellRows<float>& rows, const DifferenceInDouble& from, double unit,
  Corners<double>& corners, CellValues& values)
{
  FindValues(rows, from, unit, corners, values);
}

void ValuesOfDouble(const CellRows<double>& rows, const DifferenceInDouble& from, double unit,
  Corners<double>& corners, CellValues& values)
{
  FindValues(rows, from, unit, corners, values);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace BeamKernels
{
HWY_EXPORT(ValuesOfFloat);
HWY_EXPORT(ValuesOfDouble);
}

void FindCellValues(const CellRows<float>& rows, const DifferenceInDouble& difference, double unit,
  Corners<double>& corners, CellValues& values)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(ValuesOfFloat)(rows, difference, unit, corners, values);
}

void FindCellValues(const CellRows<double>& rows, const DifferenceInDouble& difference, double unit,
  Corners<double>& corners, CellValues& values)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(ValuesOfDouble)(rows, difference, unit, corners, values);
}

}
#endif
