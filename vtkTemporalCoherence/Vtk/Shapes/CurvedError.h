// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedError_h
#define TemporalCoherence_CurvedError_h

#include "Scene/Progress.h"
#include "Shapes/CurvedCellReader.h"

#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Bounds of the error of a curved cell's linear cells.
struct CellError
{
  double OfPoints = 0.0;    ///< share of the diagonal of the box around its points
  double OfValues = 0.0;    ///< absolute
  double LowestValue = 0.0; ///< of the cell's points
  double HighestValue = 0.0;
  CurvedCellReader::Samples Given = CurvedCellReader::Samples::All;
};

/// The largest errors of all cells.
struct CurvedError
{
  double OfPoints = 0.0; ///< share of the size of the cell
  double OfValues = 0.0; ///< share of the range of its values
};

/// Bound the errors of some cells for given numbers of parts along their edges.
/// \param numbers of the cells
/// \param areCones their parts are cones (CellDivider)
/// \param errors  receives one for each cell
/// \return false if progress stopped it
/// \throws std::bad_alloc
bool MeasureErrors(const CurvedSource& source, const std::vector<std::size_t>& numbers,
  const std::vector<int>& partsOfKinds, bool areCones, const ReportProgress& progress,
  std::vector<CellError>& errors);

}

#endif
