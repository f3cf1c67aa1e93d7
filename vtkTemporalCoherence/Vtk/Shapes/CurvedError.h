// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedError_h
#define TemporalCoherence_CurvedError_h

#include "Scene/Progress.h"
#include "Shapes/CurvedCells.h"
#include "Shapes/PointReader.h"

namespace TemporalCoherence
{

/// How far linear cells are from curved ones, at most.
struct CurvedError
{
  double OfPoints = 0.0; ///< of the size of the cell
  double OfValues = 0.0; ///< of the range of its values
};

/// Bound the error if edges are divided into this many parts (DivisionChecks).
/// \return false if progress stopped it
/// \throws std::bad_alloc
bool MeasureError(vtkUnstructuredGrid* grid, const CurvedCells& curved, const PointReader& reader,
  int parts, const ReportProgress& progress, CurvedError& error);

/// The highest order of the cells.
int OrderOf(const CurvedCells& curved);

}

#endif
