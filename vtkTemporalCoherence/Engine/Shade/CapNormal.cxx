// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/CapNormal.h"

#include <cmath>
#include <utility>

namespace TemporalCoherence
{

CapPlanes::CapPlanes(
  std::vector<glm::dvec4> ofRegion, const IndexTransform& transform, const View& view)
  : OfRegion(std::move(ofRegion))
{
  // Planes transform by the transposed matrix of the inverse.
  const glm::dvec4 inWorld(view.Forward, -glm::dot(view.Forward, view.Position) - view.Near);
  const glm::dvec4 plane = glm::transpose(transform.WorldFromIndex) * inWorld;
  const double length = glm::length(glm::dvec3(plane));
  if (length > 0.0 && std::isfinite(length) && std::isfinite(plane.w))
  {
    this->Near = plane / length;
  }
}

glm::dvec3 CapNormal(const CapPoint& cap, const Field& field, const CapPlanes& planes)
{
  double nearest = 1e-3; // cells: what remains of a depth in single precision
  glm::dvec3 found = field.Kind->FaceNormal(field, cap, nearest);
  const auto distanceTo = [&](const glm::dvec4& plane)
  { return std::abs(glm::dot(glm::dvec3(plane), cap.At) + plane.w); };
  for (const glm::dvec4& plane : planes.OfRegion)
  {
    const glm::dvec3 normal(plane);
    const double distance = distanceTo(plane);
    if (distance < nearest)
    {
      nearest = distance;
      found = glm::dot(normal, cap.Direction) > 0.0 ? -normal : normal;
    }
  }
  const bool hasNear = planes.Near != glm::dvec4(0.0);
  return hasNear && distanceTo(planes.Near) < nearest ? glm::dvec3(0.0) : found;
}

}
