// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CapNormal.h"

#include "HiddenCells.h"

#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// True if a ray that passes a plane across an axis comes from outside of the field or from a
/// hidden cell.
bool ComesFromNothing(
  const glm::dvec3& point, double plane, int axis, bool isForward, const Field& field)
{
  const glm::ivec3 last = field.Dimensions - 2;
  glm::ivec3 before = glm::clamp(glm::ivec3(glm::floor(point)), glm::ivec3(0), last);
  before[axis] = static_cast<int>(plane) - (isForward ? 1 : 0);
  const bool isOutside = before[axis] < 0 || before[axis] > last[axis];
  return isOutside || (field.Hidden && field.Hidden->IsHidden(before));
}

}

glm::dvec3 CapNormal(const glm::dvec3& point, const glm::dvec3& direction, const Field& field,
  const std::vector<glm::dvec4>& cuts)
{
  double nearest = 1e-3; // cells: what remains of a depth in single precision
  glm::dvec3 cap(0.0);
  const auto consider = [&](double distance, const glm::dvec3& normal)
  {
    nearest = distance;
    cap = normal;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double plane = std::round(point[axis]);
    const double distance = std::abs(point[axis] - plane);
    if (distance < nearest && direction[axis] != 0.0 &&
      ComesFromNothing(point, plane, axis, direction[axis] > 0.0, field))
    {
      glm::dvec3 normal(0.0);
      normal[axis] = direction[axis] > 0.0 ? -1.0 : 1.0;
      consider(distance, normal);
    }
  }
  for (const glm::dvec4& cut : cuts)
  {
    const double distance = std::abs(glm::dot(glm::dvec3(cut), point) + cut.w);
    if (distance < nearest)
    {
      const glm::dvec3 normal(cut);
      consider(distance, glm::dot(normal, direction) > 0.0 ? -normal : normal);
    }
  }
  return cap;
}

}
