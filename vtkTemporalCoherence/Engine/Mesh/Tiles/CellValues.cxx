// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tiles/CellValues.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{

NearlyLinear NearlyLinearOf(
  const std::array<glm::dvec3, 8>& points, const std::array<double, 8>& values)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // The linear function has the mean slopes of the cell. The difference is trilinear, so its
  // largest and smallest values are at corners.
  glm::dmat3 edges(0.0);
  glm::dvec3 slopes(0.0);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double sign = (corner >> axis & 1u) != 0 ? 0.25 : -0.25;
      edges[axis] += sign * points[corner];
      slopes[axis] += sign * values[corner];
    }
  }
  NearlyLinear found;
  found.Gradient = glm::transpose(glm::inverse(edges)) * slopes;
  double low = infinity, high = -infinity, largest = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double linear = glm::dot(found.Gradient, points[corner] - points[0]);
    low = std::min(low, values[corner] - linear);
    high = std::max(high, values[corner] - linear);
    largest = std::max({ largest, std::abs(values[corner]), std::abs(linear) });
  }
  const double middle = 0.5 * (low + high), offset = glm::dot(found.Gradient, points[0]);
  constexpr double rounding = 1e-12;
  const double bend = 0.5 * (high - low) + rounding * (largest + std::abs(offset));
  if (bend < infinity)
  {
    found.AtZero = middle - offset;
    found.Bend = bend;
  }
  else
  {
    found = NearlyLinear();
  }
  return found;
}

}
