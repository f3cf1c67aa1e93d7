// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedCells_h
#define TemporalCoherence_CurvedCells_h

#include "Shapes/CellDivision.h"
#include "Shapes/GivenCells.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCell;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// A kind of cells with one type, order and number of points. All interpolate by equal functions.
struct CurvedKind
{
  int Type; ///< VTK's
  CurvedShape Shape;
  int NumberOfPoints;
  int Order;
  bool IsRational;            ///< each cell has weights of its own
  std::array<int, 3> Degrees; ///< along its axes; 0: given by the number of points
  std::array<int, 3> Powers;  ///< of Bernstein polynomials along its axes; 0: other functions
};

/// The curved cells of a grid (order 2 or more), and their kinds.
struct CurvedCells
{
  std::vector<vtkIdType> Cells;
  std::vector<std::uint32_t> KindOf; ///< of each cell: its place in Kinds
  std::vector<CurvedKind> Kinds;
};

/// True for types of cells with an order of 2 or more and a volume.
bool IsCurved(int type);

/// Finds the kinds of cells, cell by cell.
class CurvedCellFinder
{
public:
  explicit CurvedCellFinder(const GivenCells& given);

  /// \pre the cell has a curved type
  /// \return false on error
  bool Add(vtkIdType cell, std::string& error);

  CurvedCells Found;

private:
  bool FindKind(vtkIdType cell, int points, const std::array<int, 3>& degrees, CurvedKind& kind,
    std::string& error) const;
  std::array<int, 3> DegreesOf(vtkIdType cell) const;

  GivenCells Given;
  vtkUnstructuredGrid* Grid;
  std::map<std::array<int, 5>, std::uint32_t> Known; ///< type, points and degrees
};

}

#endif
