// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/CapNormal.h"

#include <cmath>

namespace TemporalCoherence
{

glm::dvec3 CapNormal(const CapPoint& cap, const Field& field, const std::vector<glm::dvec4>& planes)
{
  double nearest = 1e-3; // cells: what remains of a depth in single precision
  glm::dvec3 found = field.Kind->FaceNormal(field, cap, nearest);
  for (const glm::dvec4& plane : planes)
  {
    const glm::dvec3 normal(plane);
    const double distance = std::abs(glm::dot(normal, cap.At) + plane.w);
    if (distance < nearest)
    {
      nearest = distance;
      found = glm::dot(normal, cap.Direction) > 0.0 ? -normal : normal;
    }
  }
  return found;
}

}
