// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Light/PatchPlace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{

PatchPlace PlaceOfPatch(const glm::dvec3& point, const glm::vec3& normal, double width,
  SurfaceIndex surface, HitKind kind)
{
  PatchPlace place;
  // The power of two nearest to the width of the pixel.
  const int level = std::ilogb(std::max(1.41421356 * width, std::numeric_limits<double>::min()));
  // Patches beyond this number share their light. Pixels are a billionth of the data there.
  constexpr double most = 1 << 30;
  const glm::dvec3 at = glm::clamp(point * std::ldexp(1.0, -level), -most, most);
  SetPatch(glm::ivec3(glm::floor(at)), place);
  place.Level = static_cast<std::int16_t>(level);
  place.Surface = surface;
  const glm::vec3 size = glm::abs(normal);
  const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const int side = 2 * axis + (normal[axis] < 0.0f);
  place.Side = static_cast<std::uint8_t>(8 * static_cast<int>(kind) + side);
  return place;
}

}
