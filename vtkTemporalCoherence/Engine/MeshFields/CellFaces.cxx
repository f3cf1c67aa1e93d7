// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/CellFaces.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// How the coordinates of the mesh change with those of a cell, in columns.
glm::dmat3 JacobianAt(const MeshCell& cell, const glm::dvec3& at)
{
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    const glm::dvec3& first = cell.Points[0];
    return { cell.Points[1] - first, cell.Points[2] - first, cell.Points[3] - first };
  }
  glm::dmat3 jacobian(0.0);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    glm::dvec3 weight, slope;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isHigh = (corner >> axis & 1u) != 0;
      weight[axis] = isHigh ? at[axis] : 1.0 - at[axis];
      slope[axis] = isHigh ? 1.0 : -1.0;
    }
    jacobian[0] += slope.x * weight.y * weight.z * cell.Points[corner];
    jacobian[1] += weight.x * slope.y * weight.z * cell.Points[corner];
    jacobian[2] += weight.x * weight.y * slope.z * cell.Points[corner];
  }
  return jacobian;
}

}

std::array<double, 8> WeightsAt(const MeshCell& cell, const glm::dvec3& at)
{
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    return { 1.0 - at.x - at.y - at.z, at.x, at.y, at.z, 0.0, 0.0, 0.0, 0.0 };
  }
  std::array<double, 8> weights;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    weights[corner] = ((corner & 1u) != 0 ? at.x : 1.0 - at.x) *
      ((corner & 2u) != 0 ? at.y : 1.0 - at.y) * ((corner & 4u) != 0 ? at.z : 1.0 - at.z);
  }
  return weights;
}

NearestFace FindNearestFace(const MeshCell& cell, const glm::dvec3& at)
{
  // On a face a coordinate is 0 or 1, or those of a tetrahedron sum to 1. The gradient of such a
  // coordinate is the face's normal, and its length tells how fast it grows away from the face.
  NearestFace nearest{ std::numeric_limits<double>::infinity(), glm::dvec3(0.0) };
  const glm::dmat3 rows = glm::transpose(glm::inverse(JacobianAt(cell, at)));
  const auto consider = [&](double inCell, const glm::dvec3& inward)
  {
    const double length = glm::length(inward), distance = std::abs(inCell) / length;
    if (std::isfinite(length) && length > 0.0 && distance < nearest.Distance)
    {
      nearest = { distance, -inward / length };
    }
  };
  const bool isTetrahedron = cell.Shape == MeshCellShape::Tetrahedron;
  for (int axis = 0; axis < 3; ++axis)
  {
    consider(at[axis], rows[axis]);
    if (!isTetrahedron)
    {
      consider(1.0 - at[axis], -rows[axis]);
    }
  }
  if (isTetrahedron)
  {
    consider(1.0 - at.x - at.y - at.z, -(rows[0] + rows[1] + rows[2]));
  }
  return nearest;
}

}
