// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/RangeOfMost.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

glm::dvec2 FindRangeOfMost(const Field& field, const glm::dvec2& whole)
{
  constexpr std::int64_t most = 1 << 12;
  constexpr std::size_t fewest = 2;
  constexpr double golden = 0.6180339887498949; // multiples are spread evenly, across all axes
  const glm::i64vec3 size(field.Dimensions);
  const std::int64_t count = size.x * size.y * size.z;
  std::vector<double> inside;
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      const TypedField<decltype(type)> samples(field);
      for (std::int64_t i = 0; i < std::min(count, most); ++i)
      {
        const double turns = golden * static_cast<double>(i);
        const auto at = count <= most
          ? i
          : static_cast<std::int64_t>((turns - std::floor(turns)) * static_cast<double>(count));
        const auto value = static_cast<double>(*samples.At(static_cast<int>(at % size.x),
          static_cast<int>(at / size.x % size.y), static_cast<int>(at / (size.x * size.y))));
        if (value > whole.x && value < whole.y)
        {
          inside.push_back(value);
        }
      }
    });
  // A value of a background counts once.
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  if (inside.size() < fewest)
  {
    return whole;
  }
  const std::size_t left = inside.size() / 20;
  return { inside[left], inside[inside.size() - 1 - left] };
}

}
