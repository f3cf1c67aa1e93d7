// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedDivision_h
#define TemporalCoherence_CurvedDivision_h

#include "Shapes/CurvedCells.h"
#include "Shapes/MadeCells.h"
#include "Shapes/PointReader.h"
#include "Shapes/SharedPoints.h"

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The points of divided cells: each is made by the first cell that has it.
struct CurvedPoints
{
  std::vector<std::size_t> Begins{ 0 }; ///< of each cell: its first point
  std::vector<std::uint16_t> Places;    ///< of each point in the division of its cell
};

/// The numbers that the divided cells name their points by.
std::int64_t CountDivisionIds(const CurvedCells& curved, int parts);

/// Divide the cells, without placing their points. Points are shared with those that are known, and
/// get numbers in a row behind those that were made.
/// \return false if the budget does not do, or if it was stopped
/// \throws std::bad_alloc
bool DivideCurvedCells(vtkUnstructuredGrid* grid, const CurvedCells& curved, int parts,
  MakingBudget& budget, SharedPoints& shared, MadeCells& made, CurvedPoints& points);

/// Place the points, and find their values, in parallel.
/// \param at gets them, the first one first
/// \return false if it was stopped
/// \throws std::bad_alloc
bool PlaceCurvedPoints(vtkUnstructuredGrid* grid, const CurvedCells& curved,
  const PointReader& reader, int parts, const CurvedPoints& points, const ReportProgress& progress,
  PointValue* at);

}

#endif
