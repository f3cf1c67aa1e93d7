// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedWeights_h
#define TemporalCoherence_CurvedWeights_h

#include "Scene/Progress.h"
#include "Shapes/CurvedCells.h"
#include "Shapes/PointReader.h"

#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// The values of VTK's interpolation functions of a cell: a row for each place.
/// \param places in the straight cell with edges of length 1
std::vector<double> WeightsAt(
  vtkCell* cell, CurvedShape shape, const std::vector<glm::dvec3>& places);

/// What a row of weights makes of the points of a cell. Exact where all are equal, and at points.
PointValue Weigh(const double* weights, const std::vector<PointValue>& points);

/// Weights of interpolation at given places of each kind of cells.
class KindWeights
{
public:
  KindWeights(vtkUnstructuredGrid* grid, const CurvedCells& curved,
    const std::vector<std::vector<glm::dvec3>>& places);

  /// The rows of a cell.
  /// \param cell, own for cells with weights of their own
  const double* Of(std::size_t number, vtkGenericCell* cell, std::vector<double>& own) const;

private:
  vtkUnstructuredGrid* Grid;
  const CurvedCells& Curved;
  const std::vector<std::vector<glm::dvec3>>& Places;
  std::vector<std::vector<double>> Weights;
};

/// What a thread works with.
struct CurvedWorkplace
{
  CurvedWorkplace() = default;
  CurvedWorkplace(const CurvedWorkplace&) {} // each thread has its own
  CurvedWorkplace& operator=(const CurvedWorkplace&) { return *this; }

  void Read(vtkUnstructuredGrid* grid, vtkIdType cell, const PointReader& reader);

  vtkNew<vtkIdList> Ids;
  vtkNew<vtkGenericCell> Cell;
  std::vector<PointValue> Points;
  std::vector<double> Own; ///< weights of the cell
};

/// Call `visit(number, points, rows)` for each curved cell, in parallel: with its number among
/// them, its points, and the rows of its weights at the places of its kind.
/// \return false if progress stopped it
template <typename Visit>
bool ForEachCurvedCell(vtkUnstructuredGrid* grid, const CurvedCells& curved,
  const PointReader& reader, const std::vector<std::vector<glm::dvec3>>& places,
  const ReportProgress& progress, const Visit& visit)
{
  constexpr vtkIdType cellsBetweenReports = 4096;
  const KindWeights weights(grid, curved, places);
  vtkSMPThreadLocal<CurvedWorkplace> workplaces;
  const auto work = [&](vtkIdType begin, vtkIdType end)
  {
    CurvedWorkplace& place = workplaces.Local();
    for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
    {
      place.Read(grid, curved.Cells[c], reader);
      const double* const rows = weights.Of(c, place.Cell, place.Own);
      visit(c, place.Points, rows);
    }
  };
  const auto count = static_cast<vtkIdType>(curved.Cells.size());
  for (vtkIdType done = 0; done < count; done += cellsBetweenReports)
  {
    if (progress && !progress(static_cast<double>(done) / static_cast<double>(count)))
    {
      return false;
    }
    vtkSMPTools::For(done, std::min(done + cellsBetweenReports, count), work);
  }
  return true;
}

std::vector<glm::dvec3> PlacesOf(const CellDivision& division);

}

#endif
