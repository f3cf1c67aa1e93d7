// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rows of samples that are computed with in double, in vectors. Kernels include this file once for
// each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_RealRows_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_RealRows_inl_h
#undef TemporalCoherence_RealRows_inl_h
#else
#define TemporalCoherence_RealRows_inl_h
#endif

#include "Shade/KernelsGradients.h"

#include <algorithm>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace GradientKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Loads rows of samples as vectors, one for each sample of the row, and subtracts them. Samples
/// may be large: differences from the isovalue are taken first. \tparam AreLimited differences are
/// limited, as samples that are not finite require
template <typename Stored, bool AreLimited>
struct RealRowLoader
{
  using D = hn::CappedTag<double, WidestVector / 2>;
  using DK = hn::Rebind<Stored, D>;
  using V = hn::Vec<D>;

  HWY_INLINE RealRowLoader(const RowBatch<Stored>& rows, std::size_t i)
    : From(rows)
    , At(i)
    , High(hn::LoadU(D(), &rows.High[i]))
    , Low(hn::LoadU(D(), &rows.Low[i]))
    , Limit(hn::LoadU(D(), &rows.Limit[i]))
  {
  }

  HWY_INLINE void Along(std::size_t row, V out[4]) const
  {
    hn::Vec<DK> a, b, c, e;
    hn::LoadInterleaved4(DK(), this->From.Along[row][this->At].data(), a, b, c, e);
    out[0] = this->FromIsovalue(a);
    out[1] = this->FromIsovalue(b);
    out[2] = this->FromIsovalue(c);
    out[3] = this->FromIsovalue(e);
  }

  HWY_INLINE void Beside(std::size_t row, V out[2]) const
  {
    hn::Vec<DK> a, b;
    hn::LoadInterleaved2(DK(), this->From.Beside[row][this->At].data(), a, b);
    out[0] = this->FromIsovalue(a);
    out[1] = this->FromIsovalue(b);
  }

  HWY_INLINE V Minus(V a, V b) const { return hn::Sub(a, b); }

private:
  /// Difference of Surfaces.h.
  HWY_INLINE V FromIsovalue(hn::Vec<DK> samples) const
  {
    V value;
    if constexpr (sizeof(Stored) == 8)
    {
      value = samples;
    }
    else
    {
      value = hn::PromoteTo(D(), samples);
    }
    const V difference = hn::Sub(hn::Sub(value, this->High), this->Low);
    if constexpr (!AreLimited)
    {
      return difference;
    }
    const V lowest = hn::Neg(this->Limit);
    const V raised = hn::IfThenElse(hn::Gt(difference, lowest), difference, lowest);
    return hn::IfThenElse(hn::Lt(raised, this->Limit), raised, this->Limit);
  }

  const RowBatch<Stored>& From;
  std::size_t At;
  V High, Low, Limit;
};

/// The sum of 0 times numbers, which is NaN if a number is not finite.
/// \param number of the numbers, a multiple of four vectors
template <class D>
HWY_INLINE hn::Vec<D> SumOfNothing(D d, const hn::TFromD<D>* numbers, std::size_t number)
{
  const auto zero = hn::Zero(d);
  hn::Vec<D> sums[4] = { zero, zero, zero, zero };
  for (std::size_t i = 0; i < number; i += 4 * hn::Lanes(d))
  {
    for (std::size_t j = 0; j < 4; ++j)
    {
      const auto product = hn::Mul(hn::LoadU(d, numbers + i + j * hn::Lanes(d)), zero);
      sums[j] = hn::Add(sums[j], product);
    }
  }
  return hn::Add(hn::Add(sums[0], sums[1]), hn::Add(sums[2], sums[3]));
}

/// True if no difference of the samples around points exceeds the limit: all samples are finite,
/// and limits are so small that differences are rounded as the limit is.
template <typename Stored>
HWY_INLINE bool AreWithinLimits(const RowBatch<Stored>& rows, std::size_t count)
{
  constexpr double most = 0x1p800;
  const bool areSmall =
    std::all_of(rows.Limit.begin(), rows.Limit.begin() + static_cast<std::ptrdiff_t>(count),
      [](double limit) { return limit <= most; });
  if (!areSmall)
  {
    return false;
  }
  const hn::CappedTag<Stored, WidestVector / 2> d;
  auto sum = hn::Zero(d);
  for (const auto& along : rows.Along)
  {
    sum = hn::Add(sum, SumOfNothing(d, along[0].data(), 4 * WholeVectors(count)));
  }
  for (const auto& beside : rows.Beside)
  {
    sum = hn::Add(sum, SumOfNothing(d, beside[0].data(), 2 * WholeVectors(count)));
  }
  return hn::AllTrue(d, hn::Eq(sum, hn::Zero(d)));
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
