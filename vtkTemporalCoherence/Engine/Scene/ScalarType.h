// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ScalarType_h
#define TemporalCoherence_ScalarType_h

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The type of one sample in memory.
enum class ScalarType : std::uint8_t
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

/// Call `function(T{})` with T the C++ type of `type`.
template <typename Function>
decltype(auto) DispatchScalarType(ScalarType type, Function&& function)
{
  switch (type)
  {
    case ScalarType::Int8:
      return function(std::int8_t{});
    case ScalarType::UInt8:
      return function(std::uint8_t{});
    case ScalarType::Int16:
      return function(std::int16_t{});
    case ScalarType::UInt16:
      return function(std::uint16_t{});
    case ScalarType::Int32:
      return function(std::int32_t{});
    case ScalarType::UInt32:
      return function(std::uint32_t{});
    case ScalarType::Int64:
      return function(std::int64_t{});
    case ScalarType::UInt64:
      return function(std::uint64_t{});
    case ScalarType::Float32:
      return function(float{});
    case ScalarType::Float64:
      break;
  }
  return function(double{});
}

/// Bytes of a sample.
inline std::size_t SizeOf(ScalarType type)
{
  return DispatchScalarType(type, [](auto sample) { return sizeof(sample); });
}

}

#endif
