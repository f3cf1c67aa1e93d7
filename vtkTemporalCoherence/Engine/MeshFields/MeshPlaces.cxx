// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshPlaces.h"

#include "Mesh/CellPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Call visit(cell number, cell) for each cell of the leaves whose boxes hold a point.
/// \param margin in index space, by which the point may lie outside of a box
template <typename Visit>
void VisitCellsAt(const MeshTree& tree, const glm::dvec3& point, double margin, const Visit& visit)
{
  const glm::dvec3 index = tree.ToIndex(point);
  const auto holds = [&](const FloatBox& box)
  {
    return glm::all(glm::greaterThanEqual(index + margin, glm::dvec3(box.Low))) &&
      glm::all(glm::lessThanEqual(index - margin, glm::dvec3(box.High)));
  };
  const auto childAt = [](std::int64_t block, std::size_t bit)
  { return MeshLattice::SizeOfBlock * block + static_cast<std::int64_t>(bit); };
  tree.VisitLeaves(
    [&](std::size_t level, std::int64_t block)
    {
      std::uint64_t holding = 0;
      ForEachRay(tree.ChildrenOf(level, block),
        [&](std::size_t bit)
        {
          const FloatBox& box = tree.BlockBox(level - 1, childAt(block, bit));
          holding |= static_cast<std::uint64_t>(holds(box)) << bit;
        });
      return holding;
    },
    [&](std::int64_t leaf)
    {
      MeshCell cell;
      ForEachRay(tree.ChildrenOf(0, leaf),
        [&](std::size_t bit)
        {
          const CellNumber number = tree.CellAt(childAt(leaf, bit));
          tree.Reader().Read(number, cell);
          visit(number, cell);
        });
    });
}

/// The face of a cell that is nearest to a place in it.
struct NearestFace
{
  double Distance;   ///< in the coordinates of the mesh; infinite if the cell is flat there
  glm::dvec3 Normal; ///< out of the cell, of unit length
};

NearestFace FindNearestFace(const MeshCell& cell, const glm::dvec3& at)
{
  // On a face a coordinate is 0 or 1, or those of a tetrahedron sum to 1. The gradient of such a
  // coordinate is the face's normal, and its length tells how fast it grows away from the face.
  NearestFace nearest{ std::numeric_limits<double>::infinity(), glm::dvec3(0.0) };
  const glm::dmat3 rows = glm::transpose(glm::inverse(MeshKernels::JacobianAt(cell, at)));
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

/// How far outside of a cell a point on its face may seem to be, in its own coordinates.
constexpr double OnFace = 1e-7;

}

CellNumber FindCellAt(const MeshTree& tree, const glm::dvec3& point)
{
  CellNumber found = NoCell;
  VisitCellsAt(tree, point, 0.0,
    [&](CellNumber number, const MeshCell& cell)
    {
      if (number < found && MeshKernels::FindPoint(cell, point, OnFace).IsIn)
      {
        found = number;
      }
    });
  return found;
}

glm::dvec3 MeshFaceNormal(
  const MeshTree& tree, const glm::dvec3& point, const glm::dvec3& direction, double& nearest)
{
  glm::dvec3 normal(0.0);
  const glm::dvec3 inMesh = tree.ToMesh(point);
  VisitCellsAt(tree, inMesh, nearest,
    [&](CellNumber, const MeshCell& cell)
    {
      constexpr double beside = 1e-3;
      const MeshKernels::PointInCell at = MeshKernels::FindPoint(cell, inMesh, beside);
      const NearestFace face = FindNearestFace(cell, at.At);
      if (at.IsIn && face.Distance < tree.Scale() * nearest &&
        glm::dot(face.Normal, direction) < 0.0)
      {
        nearest = face.Distance / tree.Scale();
        normal = face.Normal;
      }
    });
  return normal;
}

}
