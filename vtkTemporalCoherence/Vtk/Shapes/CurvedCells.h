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

/// Cells of the same type, order and number of points: the same functions interpolate in all.
struct CurvedKind
{
  int Type; ///< VTK's
  CurvedShape Shape;
  int NumberOfPoints;
  int Order;
  bool IsRational;            ///< each cell has weights of its own
  std::array<int, 3> Degrees; ///< along its axes; 0: the number of points tells them
  std::array<int, 3> Powers;  ///< of Bernstein polynomials along its axes; 0: it has others
};

/// The cells of a grid that have an order of 2 or more.
struct CurvedCells
{
  std::vector<vtkIdType> Cells;
  std::vector<std::uint32_t> KindOf; ///< of each cell: its place in Kinds
  std::vector<CurvedKind> Kinds;
};

/// True for types of cells with an order of 2 or more and a volume.
bool IsCurved(int type);

/// Finds kinds of cells, one cell after the other.
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
