// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/RareValues.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace TemporalCoherence
{

bool AreRareBeyond(const Field& field, const glm::dvec2& range, const glm::dvec2& whole)
{
  constexpr std::int64_t most = 1 << 16, oneOf = 1 << 12;
  constexpr double golden = 0.6180339887498949; // multiples are spread evenly, across all axes
  const glm::i64vec3 size(field.Dimensions);
  const std::int64_t count = size.x * size.y * size.z;
  if (field.Known)
  {
    return false; // samples all over a file are not read for this
  }
  std::int64_t within = 0, beyond = 0;
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
          ++(value >= range.x && value <= range.y ? within : beyond);
        }
      }
    });
  return within > 0 && beyond * oneOf <= within;
}

}
