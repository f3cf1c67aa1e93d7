// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedDivision_h
#define TemporalCoherence_CurvedDivision_h

#include "Shapes/CurvedPlan.h"
#include "Shapes/MadeCells.h"
#include "Shapes/SharedPoints.h"

#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// The points of divided cells: each is made by the first cell that has it.
struct CurvedPoints
{
  std::vector<std::size_t> Begins{ 0 }; ///< of each cell: its first point
  std::vector<DivisionPlace> Places;    ///< of each point in its cell

  std::size_t MemoryInBytes() const
  {
    return this->Begins.capacity() * sizeof(std::size_t) +
      this->Places.capacity() * sizeof(DivisionPlace);
  }
};

/// Divide the cells, without placing their points. Points are shared with those that are known, and
/// get numbers in a row behind those that were made.
/// \return false if the budget does not do, or if it was stopped
/// \throws std::bad_alloc
bool DivideCurvedCells(const CurvedSource& source, const CurvedPlan& plan, MakingBudget& budget,
  SharedPoints& shared, MadeCells& made, CurvedPoints& points);

/// Place the points, and find their values, in parallel.
/// \param at gets them, the first one first
/// \return false if it was stopped
/// \throws std::bad_alloc
bool PlaceCurvedPoints(const CurvedSource& source, const CurvedPoints& points,
  const ReportProgress& progress, PointValue* at);

}

#endif
