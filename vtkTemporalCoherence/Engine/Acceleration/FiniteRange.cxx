// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/FiniteRange.h"

#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <type_traits>

namespace TemporalCoherence
{
namespace
{

template <typename T>
struct Range
{
  void Add(T value)
  {
    this->Low = value < this->Low ? value : this->Low;
    this->High = value > this->High ? value : this->High;
  }
  void Add(const Range& range)
  {
    this->Low = std::min(this->Low, range.Low);
    this->High = std::max(this->High, range.High);
  }

  T Low = std::numeric_limits<T>::max(), High = std::numeric_limits<T>::lowest();
};

/// The range of the samples of a row. It leaves out NaN, but not infinities.
template <typename T>
Range<T> RangeOfRow(const T* row, int count, std::int64_t stride)
{
  // Several ranges at once, as each comparison waits for the one before.
  constexpr int AtOnce = 8;
  std::array<Range<T>, AtOnce> ranges;
  int first = 0;
  for (; first + AtOnce <= count; first += AtOnce)
  {
    for (int i = 0; i < AtOnce; ++i)
    {
      ranges[static_cast<std::size_t>(i)].Add(row[(first + i) * stride]);
    }
  }
  for (; first < count; ++first)
  {
    ranges[0].Add(row[first * stride]);
  }
  for (const Range<T>& range : ranges)
  {
    ranges[0].Add(range);
  }
  return ranges[0];
}

template <typename T>
Range<T> FiniteRangeOfRow(const T* row, int count, std::int64_t stride)
{
  Range<T> all = RangeOfRow(row, count, stride);
  if constexpr (std::is_floating_point_v<T>)
  {
    if (std::isinf(all.Low) || std::isinf(all.High))
    {
      all = Range<T>();
      for (int i = 0; i < count; ++i)
      {
        if (std::isfinite(row[i * stride]))
        {
          all.Add(row[i * stride]);
        }
      }
    }
  }
  return all;
}

}

glm::dvec2 FindFiniteRange(const Field& field)
{
  if (field.Known)
  {
    return field.Known->Finite;
  }
  return DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      const TypedField<T> samples(field);
      const glm::ivec3& size = field.Dimensions;
      constexpr std::int64_t Grain = 64;
      Range<T> all;
      std::mutex guard;
      ParallelForRanges(static_cast<std::int64_t>(size.y) * size.z, Grain,
        [&](std::int64_t begin, std::int64_t end)
        {
          Range<T> own;
          for (std::int64_t row = begin; row < end; ++row)
          {
            const T* const first =
              samples.At(0, static_cast<int>(row % size.y), static_cast<int>(row / size.y));
            own.Add(FiniteRangeOfRow(first, size.x, field.Strides.x));
          }
          const std::lock_guard<std::mutex> lock(guard);
          all.Add(own);
        });
      return all.Low <= all.High
        ? glm::dvec2(static_cast<double>(all.Low), static_cast<double>(all.High))
        : glm::dvec2(0.0);
    });
}

}
