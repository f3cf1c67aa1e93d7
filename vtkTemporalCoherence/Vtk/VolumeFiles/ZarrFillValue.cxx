// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ZarrMetadata.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace TemporalCoherence
{
namespace
{

/// Read the bits of a number, "0x" and hexadecimal digits, the highest first. They keep the payload
/// of NaN.
template <typename T>
bool ParseBits(const std::string& text, T& value)
{
  if (text.size() != 2 + 2 * sizeof(T) || text.compare(0, 2, "0x") != 0 ||
    text.find_first_not_of("0123456789abcdefABCDEF", 2) != std::string::npos)
  {
    return false;
  }
  const std::uint64_t bits = std::stoull(text.substr(2), nullptr, 16);
  if constexpr (sizeof(T) == sizeof(std::uint64_t))
  {
    std::memcpy(&value, &bits, sizeof(T));
  }
  else
  {
    const auto fewer = static_cast<std::uint32_t>(bits);
    std::memcpy(&value, &fewer, sizeof(T));
  }
  return true;
}

template <typename T>
bool ParseFloating(const Json& json, T& value)
{
  if (json.is_number())
  {
    const auto number = json.get<double>();
    const bool isTooLarge = std::abs(number) > static_cast<double>(std::numeric_limits<T>::max());
    value = isTooLarge ? T(0) : static_cast<T>(number);
    return !isTooLarge;
  }
  if (!json.is_string())
  {
    return false;
  }
  const auto text = json.get<std::string>();
  using Limits = std::numeric_limits<T>;
  value = text == "NaN"   ? Limits::quiet_NaN()
    : text == "Infinity"  ? Limits::infinity()
    : text == "-Infinity" ? -Limits::infinity()
                          : T(0);
  return value != T(0) || ParseBits(text, value);
}

template <typename T>
bool ParseInteger(const Json& json, T& value)
{
  using Limits = std::numeric_limits<T>;
  if (json.is_boolean())
  {
    value = static_cast<T>(json.get<bool>() ? 1 : 0);
    return true;
  }
  if (json.is_number_unsigned())
  {
    const auto number = json.get<std::uint64_t>();
    value = static_cast<T>(number);
    return number <= static_cast<std::uint64_t>(Limits::max());
  }
  if (json.is_number_integer())
  {
    const auto number = json.get<std::int64_t>();
    value = static_cast<T>(number);
    return number >= 0
      ? static_cast<std::uint64_t>(number) <= static_cast<std::uint64_t>(Limits::max())
      : std::is_signed_v<T> && number >= static_cast<std::int64_t>(Limits::min());
  }
  // Writers may store 0.0. Larger numbers with a point are not exact.
  const double number = json.is_number_float() ? json.get<double>() : 0.5;
  const bool isSmall = std::abs(number) <= 127.0 && number == std::floor(number) &&
    (std::is_signed_v<T> || number >= 0.0);
  value = isSmall ? static_cast<T>(number) : T(0);
  return isSmall;
}

}

bool ParseZarrFillValue(const Json& json, ScalarType type, SampleBytes& bytes)
{
  bytes.fill(0);
  if (json.is_null())
  {
    return true;
  }
  return DispatchScalarType(type,
    [&](auto value)
    {
      bool isGood = false;
      if constexpr (std::is_floating_point_v<decltype(value)>)
      {
        isGood = ParseFloating(json, value);
      }
      else
      {
        isGood = ParseInteger(json, value);
      }
      std::memcpy(bytes.data(), &value, sizeof(value));
      return isGood;
    });
}

}
