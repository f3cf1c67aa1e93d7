// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedDivision_h
#define TemporalCoherence_CurvedDivision_h

#include "Shapes/CurvedCells.h"
#include "Shapes/MadeCells.h"
#include "Shapes/PointReader.h"
#include "Shapes/SharedPoints.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Divide the cells. Points are shared with those that are known.
/// \throws std::bad_alloc
void DivideCurvedCells(vtkUnstructuredGrid* grid, const CurvedCells& curved,
  const PointReader& reader, int parts, SharedPoints& shared, MadeCells& made);

}

#endif
