// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/CapNormal.h"

#include <cmath>

namespace TemporalCoherence
{

glm::dvec3 CapNormal(const glm::dvec3& point, const glm::dvec3& direction, const Field& field,
  const std::vector<glm::dvec4>& planes)
{
  double nearest = 1e-3; // cells: what remains of a depth in single precision
  glm::dvec3 cap = field.Kind->FaceNormal(field, point, direction, nearest);
  for (const glm::dvec4& plane : planes)
  {
    const glm::dvec3 normal(plane);
    const double distance = std::abs(glm::dot(normal, point) + plane.w);
    if (distance < nearest)
    {
      nearest = distance;
      cap = glm::dot(normal, direction) > 0.0 ? -normal : normal;
    }
  }
  return cap;
}

}
