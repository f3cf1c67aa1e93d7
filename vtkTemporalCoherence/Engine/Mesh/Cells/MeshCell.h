// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshCell_h
#define TemporalCoherence_MeshCell_h

#include "Mesh/Cells/Mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// How a cell interpolates between its points.
enum class MeshCellShape : std::uint8_t
{
  None,        ///< not a cell with volume, or hidden
  Tetrahedron, ///< linear; 4 points
  Hexahedron   ///< trilinear; 8 points, corner (x, y, z) of the unit cube at [x + 2 y + 4 z]
};

/// Number of points of a cell, by its shape.
constexpr int NumberOfPointsIn(MeshCellShape shape)
{
  return shape == MeshCellShape::Tetrahedron ? 4 : shape == MeshCellShape::Hexahedron ? 8 : 0;
}

/// A cell, read from a mesh.
///
/// Voxels, wedges and pyramids are hexahedra, too. A wedge is a hexahedron with two edges of length
/// 0, a pyramid one with a face that is a point: the same map from the unit cube, so VTK's own
/// interpolation. Coordinates and values are as in the mesh, in double precision.
struct MeshCell
{
  MeshCellShape Shape = MeshCellShape::None;
  std::array<glm::dvec3, 8> Points; ///< in the coordinates of the mesh
  std::array<double, 8> Values;

  int NumberOfPoints() const { return NumberOfPointsIn(this->Shape); }
};

/// The points of a cell, by their numbers in a part of a mesh, in the order of MeshCell.
struct MeshCellPoints
{
  MeshCellShape Shape = MeshCellShape::None;
  std::array<std::int64_t, 8> Ids;
};

/// For each corner x + 2 y + 4 z of the unit cube, the point of the VTK cell.
using CornerOrder = std::array<std::uint8_t, 8>;
constexpr CornerOrder VoxelCorners = { 0, 1, 2, 3, 4, 5, 6, 7 };
constexpr CornerOrder HexahedronCorners = { 0, 1, 3, 2, 4, 5, 7, 6 };
constexpr CornerOrder WedgeCorners = { 0, 1, 2, 2, 3, 4, 5, 5 };
constexpr CornerOrder PyramidCorners = { 0, 1, 3, 2, 4, 4, 4, 4 };

/// True if a cell's flags hide it.
inline bool IsHidden(const MeshPart& part, std::int64_t cell)
{
  return part.Flags && (part.Flags[cell] & part.HidingFlags) != 0;
}

/// The points of a cell of a list, in the order of MeshCell. Unsupported cell types get the shape
/// None.
/// \param idAt `idAt(i)` is the i-th point in VTK's order
template <typename IdAt>
MeshCellPoints PointsInOrder(const MeshPart& part, std::int64_t cell, const IdAt& idAt)
{
  MeshCellPoints points;
  const auto take = [&](const CornerOrder& order)
  {
    points.Shape = MeshCellShape::Hexahedron;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      points.Ids[i] = idAt(order[i]);
    }
  };
  switch (static_cast<MeshCellType>(part.TypeOf(cell)))
  {
    case MeshCellType::Tetrahedron:
      points.Shape = MeshCellShape::Tetrahedron;
      for (std::int64_t i = 0; i < 4; ++i)
      {
        points.Ids[static_cast<std::size_t>(i)] = idAt(i);
      }
      break;
    case MeshCellType::Voxel:
      take(VoxelCorners);
      break;
    case MeshCellType::Hexahedron:
      take(HexahedronCorners);
      break;
    case MeshCellType::Wedge:
      take(WedgeCorners);
      break;
    case MeshCellType::Pyramid:
      take(PyramidCorners);
      break;
  }
  return points;
}

/// The points of a cell of a curvilinear grid.
inline MeshCellPoints PointsInGrid(const glm::ivec3& dimensions, std::int64_t cell)
{
  const glm::i64vec3 cells = glm::i64vec3(dimensions) - std::int64_t(1);
  const std::int64_t row = dimensions.x, slice = row * dimensions.y;
  const std::int64_t first =
    cell % cells.x + cell / cells.x % cells.y * row + cell / cells.x / cells.y * slice;
  return { MeshCellShape::Hexahedron,
    { first, first + 1, first + row, first + row + 1, first + slice, first + slice + 1,
      first + slice + row, first + slice + row + 1 } };
}

/// Find the points of a cell. Hidden cells and unsupported types get the shape None.
/// \pre the connectivity is valid
inline MeshCellPoints PointsOf(const MeshPart& part, std::int64_t cell)
{
  if (IsHidden(part, cell))
  {
    return {};
  }
  if (part.Dimensions.x > 0)
  {
    return PointsInGrid(part.Dimensions, cell);
  }
  const std::int64_t first = part.OffsetOf(cell);
  return PointsInOrder(
    part, cell, [&](std::int64_t i) { return part.Connectivity.IdAt(first + i); });
}

}

#endif
