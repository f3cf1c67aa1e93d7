// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedDivision.h"

#include "Shapes/CurvedWeights.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Numbers the points of divided cells, one cell after the other.
class PointNumbers
{
public:
  PointNumbers(SharedPoints& shared, MadeCells& made)
    : Shared(shared)
    , Made(made)
    , Next(static_cast<std::int32_t>(made.Points.size()))
  {
  }

  /// Number the points of a cell. New ones get numbers in a row, the first of which is Next.
  void Number(vtkIdList* ids, const CellDivision& division)
  {
    this->Numbers.resize(division.Points.size());
    for (std::size_t p = 0; p < division.Points.size(); ++p)
    {
      const DivisionPoint& point = division.Points[p];
      this->Name.clear();
      for (std::size_t c = 0; c < static_cast<std::size_t>(point.NumberOfCorners); ++c)
      {
        this->Name.emplace_back(ids->GetId(point.Corners[c]), point.Weights[c]);
      }
      this->Numbers[p] =
        this->Name.empty() ? this->Next : this->Shared.Find(this->Name, this->Next);
      if (this->Numbers[p] == this->Next)
      {
        this->Places.push_back(static_cast<std::uint16_t>(p));
        ++this->Next;
      }
    }
  }

  void AddCells(const CellDivision& division, vtkIdType original)
  {
    for (const DivisionCell& cell : division.Cells)
    {
      this->Ids.clear();
      for (std::size_t p = 0; p < static_cast<std::size_t>(cell.NumberOfPoints); ++p)
      {
        this->Ids.push_back(this->Numbers[static_cast<std::size_t>(cell.Points[p])]);
      }
      this->Made.AddCell(cell.Type, this->Ids, original);
    }
  }

  std::vector<std::uint16_t> Places; ///< of new points in the division of the cell that made them

private:
  SharedPoints& Shared;
  MadeCells& Made;
  std::int32_t Next;
  SharedPoints::Name Name;
  std::vector<std::int32_t> Numbers, Ids;
};

}

void DivideCurvedCells(vtkUnstructuredGrid* grid, const CurvedCells& curved,
  const PointReader& reader, int parts, SharedPoints& shared, MadeCells& made)
{
  std::vector<CellDivision> divisions;
  std::vector<std::vector<glm::dvec3>> places;
  for (const CurvedKind& kind : curved.Kinds)
  {
    divisions.push_back(Divide(kind.Shape, parts));
    places.push_back(PlacesOf(divisions.back()));
  }
  const std::size_t first = made.Points.size();
  std::vector<std::size_t> begins{ 0 }; // of the new points of each cell
  PointNumbers numbers(shared, made);
  vtkNew<vtkIdList> ids;
  for (std::size_t c = 0; c < curved.Cells.size(); ++c)
  {
    const CellDivision& division = divisions[curved.KindOf[c]];
    grid->GetCells()->GetCellAtId(curved.Cells[c], ids);
    numbers.Number(ids, division);
    numbers.AddCells(division, curved.Cells[c]);
    begins.push_back(numbers.Places.size());
  }
  made.Points.resize(first + numbers.Places.size());

  ForEachCurvedCell(grid, curved, reader, places,
    [&](std::size_t cell, const std::vector<PointValue>& points, const double* rows)
    {
      for (std::size_t p = begins[cell]; p < begins[cell + 1]; ++p)
      {
        made.Points[first + p] = Weigh(rows + numbers.Places[p] * points.size(), points);
      }
    });
}

}
