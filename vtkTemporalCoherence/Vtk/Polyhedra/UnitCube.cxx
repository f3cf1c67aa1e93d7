// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/UnitCube.h"

#include <vtkBoundingBox.h>
#include <vtkMath.h>

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{

bool ScaleToUnit(const std::vector<glm::dvec3>& points, std::vector<glm::dvec3>& scaled)
{
  vtkBoundingBox box;
  for (const glm::dvec3& point : points)
  {
    box.AddPoint(point.x, point.y, point.z);
  }
  const double longest = box.IsValid() ? box.GetMaxLength() : 0.0;
  if (!(longest > 0.0))
  {
    return false;
  }
  scaled = points;
  glm::dvec3 mean(0.0);
  for (glm::dvec3& point : scaled)
  {
    for (int a = 0; a < 3; ++a)
    {
      point[a] = (point[a] - box.GetBound(2 * a)) / longest;
      mean[a] += point[a] / static_cast<double>(points.size());
    }
  }
  double spread[3][3] = {}, sizes[3], axes[3][3];
  for (const glm::dvec3& point : scaled)
  {
    for (int a = 0; a < 9; ++a)
    {
      spread[a / 3][a % 3] += (point[a / 3] - mean[a / 3]) * (point[a % 3] - mean[a % 3]);
    }
  }
  vtkMath::Diagonalize3x3(spread, sizes, axes);
  glm::dvec3 least(0.0), most(0.0);
  std::vector<glm::dvec3> turned(scaled.size(), glm::dvec3(0.0));
  for (std::size_t p = 0; p < scaled.size(); ++p)
  {
    for (int a = 0; a < 9; ++a)
    {
      turned[p][a % 3] += (scaled[p][a / 3] - mean[a / 3]) * axes[a / 3][a % 3];
    }
    least = glm::min(least, turned[p]);
    most = glm::max(most, turned[p]);
  }
  const glm::dvec3 extents = most - least;
  const double shortest = std::min({ extents.x, extents.y, extents.z });
  constexpr double thin = 0.25, flat = 1e-14;
  if (shortest < thin * std::max({ extents.x, extents.y, extents.z }) && shortest > flat)
  {
    for (std::size_t p = 0; p < scaled.size(); ++p)
    {
      scaled[p] = (turned[p] - least) / extents;
    }
  }
  return shortest > flat;
}

}
