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

/// The points of divided cells. The first cell with a point makes it.
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

/// Divide the cells, without placing their points. Points are shared with known points. New points
/// get consecutive numbers, behind the points made before.
/// \return false if the budget is too small, or if it was stopped
/// \throws std::bad_alloc
bool DivideCurvedCells(const CurvedSource& source, const CurvedPlan& plan, MakingBudget& budget,
  SharedPoints& shared, MadeCells& made, CurvedPoints& points);

/// Place the points, and find their values, in parallel.
/// \param at receives them in order
/// \return false if it was stopped
/// \throws std::bad_alloc
bool PlaceCurvedPoints(const CurvedSource& source, const CurvedPoints& points,
  const ReportProgress& progress, PointValue* at);

}

#endif
