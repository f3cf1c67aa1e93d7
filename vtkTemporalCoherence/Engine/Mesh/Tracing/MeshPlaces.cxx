// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tracing/MeshPlaces.h"

#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Tiles/CellFolds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Tolerance for points on a cell's face, which may seem to lie outside, in the cell's coordinates.
constexpr double OnFace = 1e-7;

bool AreNumbers(const MeshCell& cell)
{
  const auto end = cell.Values.begin() + cell.NumberOfPoints();
  return std::all_of(cell.Values.begin(), end, [](double value) { return !std::isnan(value); });
}

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

/// A face through which a ray enters a cell before a place in the cell, or leaves it behind the
/// place.
struct EntryFace
{
  double Distance = std::numeric_limits<double>::infinity(); ///< in the mesh's coordinates
  glm::dvec3 Normal{ 0.0 };                             ///< of unit length, facing against the ray
  double Ago = std::numeric_limits<double>::infinity(); ///< how far back along the ray
  glm::dvec3 Middle{ 0.0 };  ///< of the face, in the coordinates of the cell
  glm::dvec3 Outward{ 0.0 }; ///< step that changes a coordinate of the cell by 1
};

/// Call visit(face) for each face through which a ray entered a cell before a place.
/// \param mayLeave faces through which the ray leaves the cell count, too
template <typename Visit>
void VisitEntryFaces(const MeshCell& cell, const glm::dvec3& at, const glm::dvec3& direction,
  bool mayLeave, const Visit& visit)
{
  // On a face, a coordinate is 0 or 1, or the coordinates of a tetrahedron sum to 1. The gradient
  // of this coordinate is the face's normal; its length converts the coordinate to a distance. The
  // rounding error in Ago keeps a ray from entering through a face that it runs along.
  constexpr double rounding = 1e-12;
  const glm::dmat3 rows = glm::transpose(glm::inverse(MeshKernels::JacobianAt(cell, at)));
  const auto consider = [&](double inCell, const glm::dvec3& inward, const glm::dvec3& middle)
  {
    const double length = glm::length(inward), along = glm::dot(inward, direction);
    const double rise = mayLeave ? std::abs(along) : along;
    if (std::isfinite(length) && rise > 0.0)
    {
      visit(EntryFace{ std::abs(inCell) / length, (along < 0.0 ? inward : -inward) / length,
        (std::abs(inCell) + rounding) / rise, middle, -inward / (length * length) });
    }
  };
  const bool isTetrahedron = cell.Shape == MeshCellShape::Tetrahedron;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 middle(isTetrahedron ? 1.0 / 3.0 : 0.5);
    middle[axis] = 0.0;
    consider(at[axis], rows[axis], middle);
    if (!isTetrahedron)
    {
      middle[axis] = 1.0;
      consider(1.0 - at[axis], -rows[axis], middle);
    }
  }
  if (isTetrahedron)
  {
    consider(1.0 - at.x - at.y - at.z, -(rows[0] + rows[1] + rows[2]), glm::dvec3(1.0 / 3.0));
  }
}

/// The last face through which the ray entered.
EntryFace FindEntryFace(
  const MeshCell& cell, const glm::dvec3& at, const glm::dvec3& direction, bool mayLeave = false)
{
  EntryFace last;
  VisitEntryFaces(cell, at, direction, mayLeave,
    [&](const EntryFace& face) { last = face.Ago < last.Ago ? face : last; });
  return last;
}

/// True if no other cell with values lies behind a face, next to a place in the cell.
bool IsOnBoundary(const MeshTree& tree, CellNumber number, const MeshCell& cell,
  const glm::dvec3& at, const EntryFace& face)
{
  // Step away from the face's edges, behind which other cells lie. Then step out of the cell.
  constexpr double inwards = 0.01, outwards = 1e-5;
  const glm::dvec3 behind =
    MeshKernels::PointAt(cell, glm::mix(at, face.Middle, inwards)) + outwards * face.Outward;
  bool isFound = false;
  VisitCellsAt(tree, behind,
    [&](CellNumber other, const MeshCell& found)
    {
      isFound = isFound ||
        (other != number && AreNumbers(found) && MayHold(found, behind) &&
          MeshKernels::FindPoint(found, behind, OnFace).IsIn);
    });
  return !isFound;
}

/// The last face on the mesh's boundary through which the ray entered. On an edge, and where a
/// plane clips the mesh, the ray may seem to enter through an inner face.
EntryFace FindOuterFace(const MeshTree& tree, const CapPoint& cap, const MeshCell& cell,
  const glm::dvec3& at, double nearest)
{
  constexpr double along = 1e-9; // of the length of the direction: the ray runs along the face
  EntryFace outer;
  VisitEntryFaces(cell, at, cap.Direction, false,
    [&](const EntryFace& face)
    {
      const double rise = -glm::dot(face.Normal, cap.Direction);
      if (face.Distance / tree.Scale() < nearest && face.Ago < outer.Ago &&
        rise > along * glm::length(cap.Direction) && IsOnBoundary(tree, cap.Cell, cell, at, face))
      {
        outer = face;
      }
    });
  return outer;
}

/// In a folded cell, a point may have several places; the place on a face counts. Where the cell
/// bulges out beyond the face, the ray reaches the face from inside.
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
  std::size_t near = 0;
  EntryFace face;
  VisitEntryFaces(cell, place.At, cap.Direction, false,
    [&](const EntryFace& other)
    {
      near += other.Distance / tree.Scale() < nearest;
      face = other.Ago < face.Ago ? other : face;
    });
  const bool isAtFace = place.IsIn && face.Distance < OnFace * tree.Scale();
  const bool mayBeFolded =
    !isAtFace && cell.Shape == MeshCellShape::Hexahedron && MeshKernels::MayFold(cell);
  if (mayBeFolded)
  {
    const EntryFace other = FindFoldedFace(cell, point, cap.Direction);
    face = !place.IsIn || other.Distance < face.Distance ? other : face;
  }
  else if (near > 1 || (near > 0 && cap.IsOnPlane))
  {
    // Rarely needed, and as slow as tracing the cap.
    const EntryFace outer = FindOuterFace(tree, cap, cell, place.At, nearest);
    face = std::isfinite(outer.Ago) || cap.IsOnPlane ? outer : face;
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
