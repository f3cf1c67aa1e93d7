// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshPlaces.h"

#include "Mesh/CellPoints.h"
#include "MeshTiles/CellFolds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// How far outside of a cell a point on its face may seem to be, in its own coordinates.
constexpr double OnFace = 1e-7;

/// False if a point surely lies outside of a cell, farther than OnFace.
bool MayHold(const MeshCell& cell, const glm::dvec3& point)
{
  glm::dvec3 low = cell.Points[0], high = low;
  for (std::size_t i = 1; i < static_cast<std::size_t>(cell.NumberOfPoints()); ++i)
  {
    low = glm::min(low, cell.Points[i]);
    high = glm::max(high, cell.Points[i]);
  }
  const glm::dvec3 margin = 10.0 * OnFace * (high - low) + OnFace * glm::abs(point);
  return glm::all(glm::greaterThanEqual(point + margin, low)) &&
    glm::all(glm::lessThanEqual(point - margin, high));
}

/// Call visit(cell number, cell) for each cell of the leaves whose boxes hold a point.
template <typename Visit>
void VisitCellsAt(const MeshTree& tree, const glm::dvec3& point, const Visit& visit)
{
  const glm::dvec3 index = tree.ToIndex(point);
  const auto holds = [&](const FloatBox& box)
  {
    return glm::all(glm::greaterThanEqual(index, glm::dvec3(box.Low))) &&
      glm::all(glm::lessThanEqual(index, glm::dvec3(box.High)));
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
          if (cell.NumberOfPoints() > 0)
          {
            visit(number, cell);
          }
        });
    });
}

/// The face of a cell through which a ray came to a place in it, or goes on from there.
struct EntryFace
{
  double Distance;   ///< in the coordinates of the mesh; infinite if the cell is flat there
  glm::dvec3 Normal; ///< out of the cell, of unit length
};

/// \param mayLeave a face through which the ray leaves the cell counts, too; the normal is turned
///                 against the ray then
EntryFace FindEntryFace(
  const MeshCell& cell, const glm::dvec3& at, const glm::dvec3& direction, bool mayLeave = false)
{
  // On a face a coordinate is 0 or 1, or those of a tetrahedron sum to 1. The gradient of such a
  // coordinate is the face's normal, and its length tells how fast it grows away from the face.
  // The ray entered through the last of the faces that it came through. Rounding errors count, so
  // that on an edge it is not a face that the ray runs along.
  constexpr double rounding = 1e-12;
  double last = std::numeric_limits<double>::infinity();
  EntryFace entry{ last, glm::dvec3(0.0) };
  const glm::dmat3 rows = glm::transpose(glm::inverse(MeshKernels::JacobianAt(cell, at)));
  const auto consider = [&](double inCell, const glm::dvec3& inward)
  {
    const double length = glm::length(inward), along = glm::dot(inward, direction);
    const double rise = mayLeave ? std::abs(along) : along;
    const double ago = (std::abs(inCell) + rounding) / rise;
    if (std::isfinite(length) && rise > 0.0 && ago < last)
    {
      last = ago;
      entry = { std::abs(inCell) / length, (along < 0.0 ? inward : -inward) / length };
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
  return entry;
}

/// A folded cell may have several places for a point. That on a face counts. Where the cell bulges
/// out beyond the face, the ray comes to it from inside.
EntryFace FindFoldedFace(const MeshCell& cell, const glm::dvec3& point, const glm::dvec3& direction)
{
  glm::dvec3 low = cell.Points[0], high = low;
  for (const glm::dvec3& corner : cell.Points)
  {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  EntryFace face{ std::numeric_limits<double>::infinity(), glm::dvec3(0.0) };
  // By rounding, the point may lie beside the cell.
  constexpr double rounding = 1e-9;
  for (const double step : { 0.0, rounding, -rounding })
  {
    const MeshKernels::PlacesInCell places = MeshKernels::FindAllPlaces(
      cell, point + step * glm::distance(low, high) * glm::normalize(direction));
    for (std::size_t i = 0; i < places.Count; ++i)
    {
      for (const bool mayLeave : { false, true })
      {
        const EntryFace other = FindEntryFace(cell, places.At[i], direction, mayLeave);
        face = other.Distance < face.Distance ? other : face;
      }
    }
  }
  return face;
}

}

CellNumber FindCellAt(const MeshTree& tree, const glm::dvec3& point)
{
  CellNumber found = NoCell;
  VisitCellsAt(tree, point,
    [&](CellNumber number, const MeshCell& cell)
    {
      if (number < found && MayHold(cell, point) &&
        MeshKernels::FindPoint(cell, point, OnFace).IsIn)
      {
        found = number;
      }
    });
  return found;
}

glm::dvec3 MeshFaceNormal(const MeshTree& tree, const CapPoint& cap, double& nearest)
{
  constexpr double beside = 1e-3;
  if (cap.Cell == NoCell)
  {
    return glm::dvec3(0.0);
  }
  MeshCell cell;
  tree.Reader().Read(cap.Cell, cell);
  const glm::dvec3 point = tree.ToMesh(cap.At);
  const MeshKernels::PointInCell place = MeshKernels::FindPoint(cell, point, beside);
  EntryFace face = FindEntryFace(cell, place.At, cap.Direction);
  const bool isAtFace = place.IsIn && face.Distance < OnFace * tree.Scale();
  if (!isAtFace && cell.Shape == MeshCellShape::Hexahedron && MeshKernels::MayFold(cell))
  {
    const EntryFace other = FindFoldedFace(cell, point, cap.Direction);
    face = !place.IsIn || other.Distance < face.Distance ? other : face;
  }
  const double distance = face.Distance / tree.Scale();
  if (!(distance < nearest))
  {
    return glm::dvec3(0.0);
  }
  nearest = distance;
  return face.Normal;
}

}
