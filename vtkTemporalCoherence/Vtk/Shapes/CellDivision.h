// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellDivision_h
#define TemporalCoherence_CellDivision_h

#include "Mesh/Mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// What a cell with curved edges looks like if they are straight.
enum class CurvedShape : std::uint8_t
{
  Tetrahedron,
  Hexahedron,
  Wedge,
  Pyramid
};

/// A point of a divided cell.
///
/// A point on a face is named by corners of that face and whole numbers as weights, without common
/// divisor. Cells that share the face give it the same name, however they number their corners.
struct DivisionPoint
{
  glm::dvec3 At;              ///< in the straight cell with edges of length 1
  int NumberOfCorners = 0;    ///< 0: inside of the cell, so in no other one
  std::array<int, 4> Corners; ///< in VTK's order
  std::array<std::int64_t, 4> Weights;
};

/// A linear cell between points of a divided cell.
struct DivisionCell
{
  MeshCellType Type;
  int NumberOfPoints;
  std::array<int, 8> Points; ///< in VTK's order
};

/// A cell whose edges are divided into equal parts in its parameters: its triangles become n^2
/// triangles, its quadrilaterals n x n quadrilaterals, whatever the shape of the cell is.
///
/// Tetrahedra become n^3 tetrahedra, hexahedra n^3 hexahedra, wedges n^3 wedges. Pyramids become
/// pyramids, upright and upside down, and tetrahedra between them.
struct CellDivision
{
  std::vector<DivisionPoint> Points;
  std::vector<DivisionCell> Cells;
};

/// \throws std::bad_alloc
CellDivision Divide(CurvedShape shape, int parts);

/// The number of its cells.
std::int64_t CountDivisionCells(CurvedShape shape, int parts);

}

#endif
