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

constexpr std::size_t CellsBetweenReports = 256;

/// Numbers the points of divided cells, one cell after the other.
class PointNumbers
{
public:
  /// \param places gets those of new points in the division of the cell that made them
  PointNumbers(SharedPoints& shared, MadeCells& made, std::vector<std::uint16_t>& places)
    : Shared(shared)
    , Made(made)
    , Places(places)
    , Next(static_cast<std::int32_t>(made.Points.size()))
  {
  }

  /// Number the points of a cell. New ones get numbers in a row, the first of which is Next.
  void Number(vtkIdList* ids, const CellDivision& division)
  {
    this->Numbers.resize(division.Points.size());
    this->Keys.resize(division.Points.size());
    for (std::size_t p = 0; p < division.Points.size(); ++p) // first, as memory takes its time
    {
      const DivisionPoint& point = division.Points[p];
      this->Name.clear();
      for (std::size_t c = 0; c < static_cast<std::size_t>(point.NumberOfCorners); ++c)
      {
        this->Name.emplace_back(ids->GetId(point.Corners[c]), point.Weights[c]);
      }
      if (!this->Name.empty())
      {
        this->Keys[p] = SharedPoints::KeyOf(this->Name);
        this->Shared.Prefetch(this->Keys[p]);
      }
    }
    for (std::size_t p = 0; p < division.Points.size(); ++p)
    {
      const bool isInside = division.Points[p].NumberOfCorners == 0;
      this->Numbers[p] = isInside ? this->Next : this->Shared.Find(this->Keys[p], this->Next);
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

private:
  SharedPoints& Shared;
  MadeCells& Made;
  std::vector<std::uint16_t>& Places;
  std::int32_t Next;
  SharedPoints::Name Name;
  std::vector<SharedPoints::Key> Keys; ///< of the points of a cell
  std::vector<std::int32_t> Numbers, Ids;
};

}

std::int64_t CountDivisionIds(const CurvedCells& curved, int parts)
{
  std::vector<std::int64_t> ids;
  for (const CurvedKind& kind : curved.Kinds)
  {
    ids.push_back(0);
    for (const DivisionCell& cell : Divide(kind.Shape, parts).Cells)
    {
      ids.back() += cell.NumberOfPoints;
    }
  }
  std::int64_t count = 0;
  for (const std::uint32_t kind : curved.KindOf)
  {
    count += ids[kind];
  }
  return count;
}

bool DivideCurvedCells(vtkUnstructuredGrid* grid, const CurvedCells& curved, int parts,
  MakingBudget& budget, SharedPoints& shared, MadeCells& made, CurvedPoints& points)
{
  std::vector<CellDivision> divisions;
  for (const CurvedKind& kind : curved.Kinds)
  {
    divisions.push_back(Divide(kind.Shape, parts));
  }
  PointNumbers numbers(shared, made, points.Places);
  vtkNew<vtkIdList> ids;
  for (std::size_t c = 0; c < curved.Cells.size(); ++c)
  {
    const CellDivision& division = divisions[curved.KindOf[c]];
    grid->GetCells()->GetCellAtId(curved.Cells[c], ids);
    numbers.Number(ids, division);
    numbers.AddCells(division, curved.Cells[c]);
    points.Begins.push_back(points.Places.size());
    if (c % CellsBetweenReports == 0 &&
      (!budget.Allows(
         made.MemoryInBytes() + shared.MemoryInBytes() + points.Places.size() * sizeof(PointValue),
         made.NumberOfCells()) ||
        !budget.GoesOn(static_cast<double>(c) / static_cast<double>(curved.Cells.size()))))
    {
      return false;
    }
  }
  return budget.Allows(
    made.MemoryInBytes() + points.Places.size() * sizeof(PointValue), made.NumberOfCells());
}

bool PlaceCurvedPoints(vtkUnstructuredGrid* grid, const CurvedCells& curved,
  const PointReader& reader, int parts, const CurvedPoints& points, const ReportProgress& progress,
  PointValue* at)
{
  std::vector<std::vector<glm::dvec3>> places;
  for (const CurvedKind& kind : curved.Kinds)
  {
    places.push_back(PlacesOf(Divide(kind.Shape, parts)));
  }
  return ForEachCurvedCell(grid, curved, reader, places, progress,
    [&](std::size_t cell, const std::vector<PointValue>& ofCell, const double* rows)
    {
      for (std::size_t p = points.Begins[cell]; p < points.Begins[cell + 1]; ++p)
      {
        at[p] = Weigh(rows + points.Places[p] * ofCell.size(), ofCell);
      }
    });
}

}
