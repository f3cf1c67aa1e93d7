// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellDivision_h
#define TemporalCoherence_CellDivision_h

#include "Mesh/Cells/Mesh.h"
#include "Shapes/StraightCell.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Numbers of parts along edges. The number of a face is a multiple of the inner number, and the
/// number of an edge is a multiple of its faces' numbers.
struct CellParts
{
  int Inside;
  std::array<int, 6> Faces;
  std::array<int, 12> Edges;

  /// One number of parts for edges, faces and the inside.
  explicit CellParts(int parts)
    : Inside(parts)
  {
    this->Faces.fill(parts);
    this->Edges.fill(parts);
  }

  bool AreEqual(const ShapeFrame& frame) const;
  int Largest(const ShapeFrame& frame) const;
};

/// Limit of the parts of an edge: places must fit into 16 bits.
constexpr int MostParts = 512;

/// A linear cell between points of a divided cell.
struct DivisionCell
{
  MeshCellType Type;
  int NumberOfPoints;
  std::array<int, 8> Points; ///< in VTK's order
};

/// Gets the cells that a curved cell is divided into.
class DivisionSink
{
public:
  virtual ~DivisionSink() = default;
  virtual void Add(const DivisionCell& cell) = 0;
};

/// Divides cells in their parameters.
///
/// Inside, tetrahedra become n^3 tetrahedra, hexahedra n^3 hexahedra, wedges n^3 wedges. Pyramids
/// become pyramids, upright and upside down, and tetrahedra between them. On faces, triangles
/// become n^2 triangles and quadrilaterals n x n quadrilaterals.
///
/// Where a face or edge of one of these parts is divided further, the part becomes a cone from its
/// middle over its faces. A face whose edges only are divided further becomes triangles around its
/// middle. So the division of a face depends on the numbers of this face and its edges alone.
class CellDivider
{
public:
  /// \param sink gets the cells, with numbers of points in the order of Places()
  /// \throws std::bad_alloc
  void Divide(CurvedShape shape, const CellParts& parts, DivisionSink& sink);

  /// Divide all parts into cones from their middles, even if no face is divided further.
  /// \throws std::bad_alloc
  void DivideIntoCones(CurvedShape shape, int parts, DivisionSink& sink);

  /// The points of the last cell.
  const std::vector<DivisionPlace>& Places() const { return this->PlacesOfCell; }

  /// The number of a place in the present division.
  int NumberOf(const glm::ivec3& place);

private:
  void Divide(CurvedShape shape, const CellParts& parts, bool onlyCones, DivisionSink& sink);

  struct Entry
  {
    std::uint64_t Key = 0;
    int Number = -1;
  };

  int* FindNumber(const glm::ivec3& place);
  void Grow();

  std::vector<DivisionPlace> PlacesOfCell;
  std::vector<int> Lattice;   ///< numbers of points, if all parts are equal
  std::vector<Entry> Entries; ///< numbers of points otherwise, by hash; the size is a power of two
  int Unit = 0, Row = 0, Of = 0;
};

/// A divided cell.
struct CellDivision
{
  std::vector<DivisionPlace> Points;
  std::vector<DivisionCell> Cells;
};

/// \throws std::bad_alloc
CellDivision Divide(CurvedShape shape, const CellParts& parts);

/// \throws std::bad_alloc
CellDivision DivideIntoCones(CurvedShape shape, int parts);

/// Number of cells in a division, and of point ids in these cells.
struct DivisionSize
{
  std::int64_t Cells = 0, Ids = 0;
};

DivisionSize SizeOf(CurvedShape shape, const CellParts& parts);

}

#endif
