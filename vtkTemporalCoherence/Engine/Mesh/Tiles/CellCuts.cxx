// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tiles/CellCuts.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{

void FindPolygon(const glm::dvec3* points, const std::array<double, 4>& values, glm::dvec3* polygon)
{
  std::array<std::size_t, 4> inside, outside;
  std::size_t numberInside = 0, numberOutside = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    (values[i] >= 0.0 ? inside[numberInside++] : outside[numberOutside++]) = i;
  }
  const auto cut = [&](std::size_t i, std::size_t j)
  { return points[i] + values[i] / (values[i] - values[j]) * (points[j] - points[i]); };
  if (numberInside == 2)
  {
    polygon[0] = cut(inside[0], outside[0]);
    polygon[1] = cut(inside[0], outside[1]);
    polygon[2] = cut(inside[1], outside[1]);
    polygon[3] = cut(inside[1], outside[0]);
    return;
  }
  const bool isOneInside = numberInside == 1;
  const std::size_t lone = isOneInside ? inside[0] : outside[0];
  const std::array<std::size_t, 4>& others = isOneInside ? outside : inside;
  for (std::size_t i = 0; i < 3; ++i)
  {
    polygon[i] = cut(lone, others[i]);
  }
  polygon[3] = polygon[2];
}

void FindSlab(const glm::dvec3* points, const std::array<double, 4>& values,
  const glm::dvec2& bounds, glm::dvec3* slab)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (values[i] >= bounds[0] && values[i] <= bounds[1])
    {
      slab[count++] = points[i];
    }
  }
  for (int side = 0; side < 2; ++side)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      for (std::size_t j = 0; j < values.size(); ++j)
      {
        if (values[i] < bounds[side] && values[j] > bounds[side])
        {
          const double share = (bounds[side] - values[i]) / (values[j] - values[i]);
          slab[count++] = points[i] + share * (points[j] - points[i]);
        }
      }
    }
  }
  std::fill(slab + count, slab + MostSlabPoints, slab[0]);
}

std::array<glm::dvec3, MostHullPoints> HullOf(
  const std::array<glm::dvec3, 8>& points, const std::array<double, 8>& values)
{
  double largest = 0.0, smallest = std::abs(values[0]);
  for (const double value : values)
  {
    largest = std::max(largest, std::abs(value));
    smallest = std::min(smallest, std::abs(value));
  }
  std::array<glm::dvec3, MostHullPoints> hull;
  std::size_t count = 0;
  // If the surface nearly passes a corner, and another corner has a far larger value, the search is
  // less exact.
  const bool isNearCorner = smallest <= 1e-4 * largest;
  if (isNearCorner)
  {
    std::copy(points.begin(), points.end(), hull.begin());
    count = points.size();
  }
  for (std::size_t i = 0; i < values.size() && !isNearCorner; ++i)
  {
    for (std::size_t j = 0; j < values.size(); ++j)
    {
      if (values[i] > 0.0 && values[j] < 0.0)
      {
        hull[count++] = points[i] + values[i] / (values[i] - values[j]) * (points[j] - points[i]);
      }
    }
  }
  std::fill(hull.begin() + static_cast<std::ptrdiff_t>(count), hull.end(), hull[count - 1]);
  return hull;
}

}
