// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/RawLayout.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{

bool BytesOf(const glm::ivec3& dimensions, ScalarType type, std::uint64_t& bytes)
{
  constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
  bytes = SizeOf(type);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (dimensions[axis] <= 0 || bytes > most / static_cast<std::uint64_t>(dimensions[axis]))
    {
      return false;
    }
    bytes *= static_cast<std::uint64_t>(dimensions[axis]);
  }
  return true;
}

bool CheckLayout(const std::string& path, const RawLayout& layout, std::string& error)
{
  std::uint64_t bytes = 0;
  if (!BytesOf(layout.Dimensions, layout.Type, bytes))
  {
    error = "The dimensions " + TextOf(layout.Dimensions) + " of '" + path +
      "' are not positive or too large; correct them.";
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = layout.Spacing[axis];
    if (!std::isfinite(spacing) || !(spacing > 0.0) || !std::isfinite(layout.Origin[axis]))
    {
      error = "The spacing of '" + path + "' must be positive and its origin finite; correct them.";
      return false;
    }
  }
  return true;
}

std::string TextOf(const glm::ivec3& dimensions)
{
  return std::to_string(dimensions.x) + " x " + std::to_string(dimensions.y) + " x " +
    std::to_string(dimensions.z);
}

}
