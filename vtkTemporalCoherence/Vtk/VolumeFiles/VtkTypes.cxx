// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/VtkTypes.h"

#include <vtkSetGet.h>
#include <vtkType.h>

#include <limits>

namespace TemporalCoherence
{
namespace
{

/// True if two types have the same numbers.
template <typename A, typename B>
constexpr bool AreEqual()
{
  using OfA = std::numeric_limits<A>;
  using OfB = std::numeric_limits<B>;
  return sizeof(A) == sizeof(B) && OfA::is_integer == OfB::is_integer &&
    OfA::is_signed == OfB::is_signed;
}

template <typename T>
std::optional<ScalarType> TypeOf()
{
  for (int i = 0; i <= static_cast<int>(ScalarType::Float64); ++i)
  {
    const auto type = static_cast<ScalarType>(i);
    if (DispatchScalarType(type, [](auto sample) { return AreEqual<T, decltype(sample)>(); }))
    {
      return type;
    }
  }
  return std::nullopt;
}

}

int VtkTypeOf(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
      return VTK_SIGNED_CHAR;
    case ScalarType::UInt8:
      return VTK_UNSIGNED_CHAR;
    case ScalarType::Int16:
      return VTK_SHORT;
    case ScalarType::UInt16:
      return VTK_UNSIGNED_SHORT;
    case ScalarType::Int32:
      return VTK_INT;
    case ScalarType::UInt32:
      return VTK_UNSIGNED_INT;
    case ScalarType::Int64:
      return VTK_LONG_LONG;
    case ScalarType::UInt64:
      return VTK_UNSIGNED_LONG_LONG;
    case ScalarType::Float32:
      return VTK_FLOAT;
    case ScalarType::Float64:
      break;
  }
  return VTK_DOUBLE;
}

std::optional<ScalarType> TypeOfVtk(int type)
{
  switch (type)
  {
    vtkTemplateMacro(return TypeOf<VTK_TT>());
    default:
      return std::nullopt;
  }
}

}
