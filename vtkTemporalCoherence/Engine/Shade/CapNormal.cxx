// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/CapNormal.h"

#include "Acceleration/HiddenCells.h"
#include "Scene/GridCoordinates.h"

#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// The plane between cells, across an axis, that is nearest to a coordinate.
int NearestPlane(const Field& field, int axis, double at)
{
  if (!field.Grid)
  {
    return static_cast<int>(std::round(glm::clamp(at, -1.0, field.Dimensions[axis] + 0.0)));
  }
  const int cell = field.Grid->CellOf(axis, at);
  const double toLow = at - field.Grid->At(axis, cell);
  const double toHigh = field.Grid->At(axis, cell + 1) - at;
  return toHigh < toLow ? cell + 1 : cell;
}

/// Where a plane between cells lies.
double PlaneAt(const Field& field, int axis, int plane)
{
  const bool isInside = plane >= 0 && plane < field.Dimensions[axis];
  return field.Grid && isInside ? field.Grid->At(axis, plane) : plane;
}

/// The cell that a point lies in, or the nearest one.
glm::ivec3 CellOf(const Field& field, const glm::dvec3& point)
{
  glm::ivec3 cell;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = field.Dimensions[axis] - 2;
    cell[axis] = field.Grid ? field.Grid->CellOf(axis, point[axis])
                            : static_cast<int>(std::floor(glm::clamp(point[axis], 0.0, last)));
  }
  return cell;
}

/// True if a ray that passes a plane across an axis comes from outside of the field or from a
/// hidden cell.
bool ComesFromNothing(
  const glm::dvec3& point, int plane, int axis, bool isForward, const Field& field)
{
  glm::ivec3 before = CellOf(field, point);
  before[axis] = plane - (isForward ? 1 : 0);
  const bool isOutside = before[axis] < 0 || before[axis] > field.Dimensions[axis] - 2;
  return isOutside || (field.Hidden && field.Hidden->IsHidden(before));
}

}

glm::dvec3 CapNormal(const glm::dvec3& point, const glm::dvec3& direction, const Field& field,
  const std::vector<glm::dvec4>& cuts)
{
  double nearest = 1e-3; // cells: what remains of a depth in single precision
  glm::dvec3 cap(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int plane = NearestPlane(field, axis, point[axis]);
    const double distance = std::abs(point[axis] - PlaneAt(field, axis, plane));
    if (distance < nearest && direction[axis] != 0.0 &&
      ComesFromNothing(point, plane, axis, direction[axis] > 0.0, field))
    {
      nearest = distance;
      cap = glm::dvec3(0.0);
      cap[axis] = direction[axis] > 0.0 ? -1.0 : 1.0;
    }
  }
  for (const glm::dvec4& cut : cuts)
  {
    const glm::dvec3 normal(cut);
    const double distance = std::abs(glm::dot(normal, point) + cut.w);
    if (distance < nearest)
    {
      nearest = distance;
      cap = glm::dot(normal, direction) > 0.0 ? -normal : normal;
    }
  }
  return cap;
}

}
