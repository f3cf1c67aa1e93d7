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

/// How far the linear cells of a curved one are from it, at most.
struct CellError
{
  double OfPoints = 0.0;    ///< in parts of the diagonal of the box around its points
  double OfValues = 0.0;    ///< as they are
  double LowestValue = 0.0; ///< of its points
  double HighestValue = 0.0;
  CurvedCellReader::Samples Given = CurvedCellReader::Samples::All;
};

/// The largest errors of all cells.
struct CurvedError
{
  double OfPoints = 0.0; ///< of the size of the cell
  double OfValues = 0.0; ///< of the range of its values
};

/// Bound the errors of some cells if their edges are divided into so many parts.
/// \param numbers of the cells
/// \param areCones their parts are cones (CellDivider)
/// \param errors  gets one for each
/// \return false if progress stopped it
/// \throws std::bad_alloc
bool MeasureErrors(const CurvedSource& source, const std::vector<std::size_t>& numbers,
  const std::vector<int>& partsOfKinds, bool areCones, const ReportProgress& progress,
  std::vector<CellError>& errors);

}

#endif
