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

glm::dvec3 CapNormal(
  CapPoint cap, const Field& field, const FieldNormals& normals, const CapPlanes& planes)
{
  double nearest = 1e-3; // in cells: error of a depth in single precision
  glm::dvec3 found(0.0);
  const auto isNearer = [&](const glm::dvec4& plane)
  {
    const double distance = std::abs(glm::dot(glm::dvec3(plane), cap.At) + plane.w);
    const bool isNear = distance < nearest;
    nearest = isNear ? distance : nearest;
    cap.IsOnPlane |= isNear;
    return isNear;
  };
  for (const glm::dvec4& plane : planes.OfRegion)
  {
    const glm::dvec3 normal(plane);
    if (isNearer(plane))
    {
      found = glm::dot(normal, cap.Direction) > 0.0 ? -normal : normal;
    }
  }
  if (planes.Near != glm::dvec4(0.0) && isNearer(planes.Near))
  {
    found = glm::dvec3(0.0);
  }
  const glm::dvec3 ofFace = normals.FaceNormal(field, cap, nearest);
  return ofFace != glm::dvec3(0.0) ? ofFace : found;
}

}
