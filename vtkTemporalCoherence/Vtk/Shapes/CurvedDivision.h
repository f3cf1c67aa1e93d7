// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedDivision_h
#define TemporalCoherence_CurvedDivision_h

#include "Shapes/CurvedCells.h"
#include "Shapes/MadeCells.h"
#include "Shapes/SharedPoints.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// How far linear cells are from curved ones, at most.
struct CurvedError
{
  double OfPoints = 0.0; ///< of the size of the cell
  double OfValues = 0.0; ///< of the range of its values
};

/// Bound the error if edges are divided into this many parts (DivisionChecks).
/// \throws std::bad_alloc
CurvedError MeasureError(
  vtkUnstructuredGrid* grid, const CurvedCells& curved, const PointReader& reader, int parts);

/// The highest order of the cells.
int OrderOf(const CurvedCells& curved);

/// Divide the cells. Points are shared with those that are known.
/// \throws std::bad_alloc
void DivideCurvedCells(vtkUnstructuredGrid* grid, const CurvedCells& curved,
  const PointReader& reader, int parts, SharedPoints& shared, MadeCells& made);

}

#endif
