// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/KernelsGradients.h"

#include <algorithm>
#include <limits>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Shade/KernelsGradients.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsPacked-inl.h"

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
/// may be large: differences from the isovalue are taken first.
/// \tparam AreLimited differences are limited, as samples that are not finite require
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

template <class V>
HWY_INLINE V Mix(V a, V b, V weightOfA, V weightOfB)
{
  return hn::Add(hn::Mul(weightOfA, a), hn::Mul(weightOfB, b));
}

/// Loads rows as vectors, one for each sample of the row, and subtracts them. Integers of up to 16
/// bits are subtracted before they are converted to float, which is exact.
template <typename Stored>
struct IntegerRowLoader : PackedSamples::HWY_NAMESPACE::IntegerRows<Stored>
{
  using Rows = PackedSamples::HWY_NAMESPACE::IntegerRows<Stored>;

  HWY_INLINE IntegerRowLoader(const RowBatch<Stored>& rows, std::size_t i)
    : From(rows)
    , At(i)
  {
  }

  HWY_INLINE void Along(std::size_t row, typename Rows::V out[4]) const
  {
    Rows::Load(&this->From.Along[row][this->At], out);
  }
  HWY_INLINE void Beside(std::size_t row, typename Rows::V out[2]) const
  {
    Rows::Load(&this->From.Beside[row][this->At], out);
  }

  HWY_INLINE hn::Vec<typename Rows::D> Minus(typename Rows::V a, typename Rows::V b) const
  {
    return Rows::AsFloats(hn::Sub(a, b));
  }

private:
  const RowBatch<Stored>& From;
  std::size_t At;
};

/// Loads rows by gathering samples from where they lie in memory.
template <typename T>
struct GatheringLoader : PackedSamples::HWY_NAMESPACE::GatheredRows<T>
{
  using Rows = PackedSamples::HWY_NAMESPACE::GatheredRows<T>;

  HWY_INLINE GatheringLoader(
    const NarrowSamples<T>& samples, const hn::Vec<typename Rows::Places> cell[3])
    : Rows(samples, cell)
  {
  }

  HWY_INLINE void Along(std::size_t row, typename Rows::V out[4]) const
  {
    this->Four(static_cast<int>(row & 1u), static_cast<int>(row >> 1u), out);
  }

  HWY_INLINE void Beside(std::size_t row, typename Rows::V out[2]) const
  {
    // Rows lie outside of the cell along one axis, and on a cell face along the other axis.
    const int across = (row & 2u) != 0 ? 2 : -1, end = static_cast<int>(row & 1u);
    this->Two(row < 4 ? across : end, row < 4 ? end : across, out);
  }

  HWY_INLINE hn::Vec<typename Rows::D> Minus(typename Rows::V a, typename Rows::V b) const
  {
    return Rows::AsFloats(hn::Sub(a, b));
  }
};

HWY_INLINE hn::Vec<hn::CappedTag<float, WidestVector>> LoadWhole(
  hn::CappedTag<float, WidestVector> d, const std::int32_t* from)
{
  return hn::ConvertTo(d, hn::LoadU(hn::Rebind<std::int32_t, decltype(d)>(), from));
}
HWY_INLINE hn::Vec<hn::CappedTag<double, WidestVector / 2>> LoadWhole(
  hn::CappedTag<double, WidestVector / 2> d, const std::int32_t* from)
{
  return hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::int32_t, decltype(d)>(), from));
}

/// Weights for interpolation along an axis: of values at the first and second corner, and of
/// differences there, divided by their one or two steps.
template <class V>
struct AxisWeights
{
  V First, Second, FirstDifference, SecondDifference;
};

template <class D, typename Real>
HWY_INLINE AxisWeights<hn::Vec<D>> WeightsAlong(
  D d, std::size_t axis, int samples, const CellPoints<Real>& points, std::size_t i)
{
  using V = hn::Vec<D>;
  const V one = hn::Set(d, Real(1)), half = hn::Set(d, Real(0.5)), zero = hn::Zero(d);
  const V at = hn::LoadU(d, &points.At[axis][i]);
  const V cell = LoadWhole(d, &points.Cell[axis][i]);
  const auto hasBefore = hn::Gt(cell, zero);
  const auto hasBehind = hn::Lt(cell, hn::Set(d, static_cast<Real>(samples - 2)));
  AxisWeights<V> weights;
  weights.First = hn::Sub(one, at);
  weights.Second = at;
  weights.FirstDifference = hn::Mul(weights.First, hn::IfThenElse(hasBefore, half, one));
  weights.SecondDifference = hn::Mul(weights.Second, hn::IfThenElse(hasBehind, half, one));
  return weights;
}

/// One component of the gradients: the differences on the four edges of the cell along an axis,
/// interpolated between edges 0 and 1, 2 and 3, and then between these.
template <class V>
HWY_INLINE V Across(const V edges[4], const AxisWeights<V>& u, const AxisWeights<V>& v)
{
  const V low = Mix(edges[0], edges[1], u.First, u.Second);
  const V high = Mix(edges[2], edges[3], u.First, u.Second);
  return Mix(low, high, v.First, v.Second);
}

HWY_INLINE void StoreAsDoubles(
  hn::CappedTag<double, WidestVector / 2> d, hn::Vec<decltype(d)> value, double* to)
{
  hn::StoreU(value, d, to);
}
HWY_INLINE void StoreAsDoubles(
  hn::CappedTag<float, WidestVector> d, hn::Vec<decltype(d)> value, double* to)
{
  const hn::CappedTag<double, WidestVector / 2> dd;
  const hn::Rebind<float, decltype(dd)> part;
  std::array<float, WidestVector> values;
  hn::StoreU(value, d, values.data());
  for (std::size_t i = 0; i < hn::Lanes(d); i += hn::Lanes(dd))
  {
    hn::StoreU(hn::PromoteTo(dd, hn::LoadU(part, &values[i])), dd, to + i);
  }
}

/// \param loaderAt makes the loader of rows for a vector of points
template <typename Loader, typename Real, typename LoaderAt>
HWY_INLINE void InterpolateAll(const glm::ivec3& dimensions, const CellPoints<Real>& points,
  const LoaderAt& loaderAt, Vectors& gradients)
{
  const typename Loader::D d;
  using V = hn::Vec<decltype(d)>;
  for (std::size_t i = 0; i < points.Count; i += hn::Lanes(d))
  {
    const auto wx = WeightsAlong(d, 0, dimensions.x, points, i);
    const auto wy = WeightsAlong(d, 1, dimensions.y, points, i);
    const auto wz = WeightsAlong(d, 2, dimensions.z, points, i);
    const Loader loader = loaderAt(i);
    typename Loader::V corner[8], row[4], before[2], behind[2];
    V edges[4];
    for (std::size_t yz = 0; yz < 4; ++yz)
    {
      loader.Along(yz, row);
      corner[2 * yz] = row[1];
      corner[2 * yz + 1] = row[2];
      edges[yz] = Mix(loader.Minus(row[2], row[0]), loader.Minus(row[3], row[1]),
        wx.FirstDifference, wx.SecondDifference);
    }
    StoreAsDoubles(d, Across(edges, wy, wz), &gradients[0][i]);
    for (std::size_t z = 0; z < 2; ++z)
    {
      loader.Beside(z, before);
      loader.Beside(2 + z, behind);
      for (std::size_t x = 0; x < 2; ++x)
      {
        edges[2 * z + x] = Mix(loader.Minus(corner[4 * z + 2 + x], before[x]),
          loader.Minus(behind[x], corner[4 * z + x]), wy.FirstDifference, wy.SecondDifference);
      }
    }
    StoreAsDoubles(d, Across(edges, wx, wz), &gradients[1][i]);
    for (std::size_t y = 0; y < 2; ++y)
    {
      loader.Beside(4 + y, before);
      loader.Beside(6 + y, behind);
      for (std::size_t x = 0; x < 2; ++x)
      {
        edges[2 * y + x] = Mix(loader.Minus(corner[4 + 2 * y + x], before[x]),
          loader.Minus(behind[x], corner[2 * y + x]), wz.FirstDifference, wz.SecondDifference);
      }
    }
    StoreAsDoubles(d, Across(edges, wx, wy), &gradients[2][i]);
  }
}

template <typename Loader, typename Stored, typename Real>
HWY_INLINE void InterpolateLoaded(const glm::ivec3& dimensions, const CellPoints<Real>& points,
  const RowBatch<Stored>& rows, Vectors& gradients)
{
  InterpolateAll<Loader>(
    dimensions, points, [&](std::size_t i) HWY_ATTR { return Loader(rows, i); }, gradients);
}

template <typename Stored>
HWY_INLINE void InterpolateRows(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<Stored>& rows, Vectors& gradients)
{
  InterpolateLoaded<IntegerRowLoader<Stored>>(dimensions, points, rows, gradients);
}

template <typename Stored>
HWY_INLINE void InterpolateRows(const glm::ivec3& dimensions, const CellPoints<double>& points,
  const RowBatch<Stored>& rows, Vectors& gradients)
{
  if (AreWithinLimits(rows, points.Count))
  {
    InterpolateLoaded<RealRowLoader<Stored, false>>(dimensions, points, rows, gradients);
  }
  else
  {
    InterpolateLoaded<RealRowLoader<Stored, true>>(dimensions, points, rows, gradients);
  }
}

template <typename T>
HWY_INLINE void InterpolateGathered(
  const NarrowSamples<T>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  using Loader = GatheringLoader<T>;
  const glm::ivec3 endless(std::numeric_limits<std::int32_t>::max()); // all cells are inner ones
  InterpolateAll<Loader>(
    endless, points,
    [&](std::size_t i) HWY_ATTR
    {
      const typename Loader::Places d;
      const hn::Vec<decltype(d)> cell[3] = { hn::LoadU(d, &points.Cell[0][i]),
        hn::LoadU(d, &points.Cell[1][i]), hn::LoadU(d, &points.Cell[2][i]) };
      return Loader(samples, cell);
    },
    gradients);
}

void GradientsUInt8(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::uint8_t>& rows, Vectors& gradients)
{
  InterpolateRows(dimensions, points, rows, gradients);
}

void GradientsInt8(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::int8_t>& rows, Vectors& gradients)
{
  InterpolateRows(dimensions, points, rows, gradients);
}

void GradientsUInt16(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::uint16_t>& rows, Vectors& gradients)
{
  InterpolateRows(dimensions, points, rows, gradients);
}

void GradientsInt16(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::int16_t>& rows, Vectors& gradients)
{
  InterpolateRows(dimensions, points, rows, gradients);
}

void GradientsFloat(const glm::ivec3& dimensions, const CellPoints<double>& points,
  const RowBatch<float>& rows, Vectors& gradients)
{
  InterpolateRows(dimensions, points, rows, gradients);
}

void GradientsDouble(const glm::ivec3& dimensions, const CellPoints<double>& points,
  const RowBatch<double>& rows, Vectors& gradients)
{
  InterpolateRows(dimensions, points, rows, gradients);
}

void GatherUInt8(
  const NarrowSamples<std::uint8_t>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  InterpolateGathered(samples, points, gradients);
}

void GatherInt8(
  const NarrowSamples<std::int8_t>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  InterpolateGathered(samples, points, gradients);
}

void GatherUInt16(
  const NarrowSamples<std::uint16_t>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  InterpolateGathered(samples, points, gradients);
}

void GatherInt16(
  const NarrowSamples<std::int16_t>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  InterpolateGathered(samples, points, gradients);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace GradientKernels
{

HWY_EXPORT(GradientsUInt8);
HWY_EXPORT(GradientsInt8);
HWY_EXPORT(GradientsUInt16);
HWY_EXPORT(GradientsInt16);
HWY_EXPORT(GradientsFloat);
HWY_EXPORT(GradientsDouble);
HWY_EXPORT(GatherUInt8);
HWY_EXPORT(GatherInt8);
HWY_EXPORT(GatherUInt16);
HWY_EXPORT(GatherInt16);

void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::uint8_t>& rows, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GradientsUInt8)(dimensions, points, rows, gradients);
}

void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::int8_t>& rows, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GradientsInt8)(dimensions, points, rows, gradients);
}

void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::uint16_t>& rows, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GradientsUInt16)(dimensions, points, rows, gradients);
}

void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::int16_t>& rows, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GradientsInt16)(dimensions, points, rows, gradients);
}

void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<double>& points,
  const RowBatch<float>& rows, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GradientsFloat)(dimensions, points, rows, gradients);
}

void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<double>& points,
  const RowBatch<double>& rows, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GradientsDouble)(dimensions, points, rows, gradients);
}

void GatherGradients(
  const NarrowSamples<std::uint8_t>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GatherUInt8)(samples, points, gradients);
}

void GatherGradients(
  const NarrowSamples<std::int8_t>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GatherInt8)(samples, points, gradients);
}

void GatherGradients(
  const NarrowSamples<std::uint16_t>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GatherUInt16)(samples, points, gradients);
}

void GatherGradients(
  const NarrowSamples<std::int16_t>& samples, const CellPoints<float>& points, Vectors& gradients)
{
  HWY_DYNAMIC_DISPATCH(GatherInt16)(samples, points, gradients);
}

}
}
#endif
