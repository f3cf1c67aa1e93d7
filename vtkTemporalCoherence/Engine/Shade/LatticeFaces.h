// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LatticeFaces_h
#define TemporalCoherence_LatticeFaces_h

#include "Scene/CapPoint.h"
#include "Scene/Field.h"
#include "Scene/HiddenCells.h"

#include <glm/glm.hpp>

#include <cmath>

namespace TemporalCoherence
{

/// FieldNormals::FaceNormal for cells between axis-aligned planes.
/// \param planes has Nearest(axis, x): the plane nearest to a coordinate; At(axis, plane): its
///               coordinate; and CellOf(axis, x): the cell that holds a coordinate, or the nearest
///               one
template <typename Planes>
glm::dvec3 LatticeFaceNormal(
  const Planes& planes, const Field& field, const CapPoint& cap, double& nearest)
{
  const glm::dvec3 &point = cap.At, &direction = cap.Direction;
  const auto comesFromNothing = [&](int plane, int axis)
  {
    glm::ivec3 before(
      planes.CellOf(0, point.x), planes.CellOf(1, point.y), planes.CellOf(2, point.z));
    before[axis] = plane - (direction[axis] > 0.0 ? 1 : 0);
    const bool isOutside = before[axis] < 0 || before[axis] > field.Dimensions[axis] - 2;
    return isOutside || (field.Hidden && field.Hidden->IsHidden(before));
  };
  glm::dvec3 normal(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int plane = planes.Nearest(axis, point[axis]);
    const double distance = std::abs(point[axis] - planes.At(axis, plane));
    if (distance < nearest && direction[axis] != 0.0 && comesFromNothing(plane, axis))
    {
      nearest = distance;
      normal = glm::dvec3(0.0);
      normal[axis] = direction[axis] > 0.0 ? -1.0 : 1.0;
    }
  }
  return normal;
}

}

#endif
