// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedDivision.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Weights of interpolation at given places of each kind of cells.
class KindWeights
{
public:
  KindWeights(vtkUnstructuredGrid* grid, const CurvedCells& curved,
    const std::vector<std::vector<glm::dvec3>>& places)
    : Grid(grid)
    , Curved(curved)
    , Places(places)
  {
    vtkNew<vtkGenericCell> cell;
    for (std::size_t k = 0; k < curved.Kinds.size(); ++k)
    {
      const CurvedKind& kind = curved.Kinds[k];
      grid->GetCell(kind.Example, cell); // of all kinds, as the first call is not thread-safe
      this->Weights.push_back(
        kind.IsRational ? std::vector<double>() : WeightsAt(cell, kind.Shape, places[k]));
    }
  }

  /// \param own, cell for cells with weights of their own
  const double* Of(std::size_t number, vtkGenericCell* cell, std::vector<double>& own) const
  {
    const std::uint32_t k = this->Curved.KindOf[number];
    const CurvedKind& kind = this->Curved.Kinds[k];
    if (!kind.IsRational)
    {
      return this->Weights[k].data();
    }
    this->Grid->GetCell(this->Curved.Cells[number], cell);
    own = WeightsAt(cell, kind.Shape, this->Places[k]);
    return own.data();
  }

private:
  vtkUnstructuredGrid* Grid;
  const CurvedCells& Curved;
  const std::vector<std::vector<glm::dvec3>>& Places;
  std::vector<std::vector<double>> Weights;
};

std::vector<glm::dvec3> PlacesOf(const CellDivision& division)
{
  std::vector<glm::dvec3> places;
  for (const DivisionPoint& point : division.Points)
  {
    places.push_back(point.At);
  }
  return places;
}

/// What a thread works with.
struct Workplace
{
  Workplace() = default;
  Workplace(const Workplace&) {} // each thread has its own
  Workplace& operator=(const Workplace&) { return *this; }

  vtkNew<vtkIdList> Ids;
  vtkNew<vtkGenericCell> Cell;
  std::vector<PointValue> Points;
  std::vector<double> Own; ///< weights of the cell

  void Read(vtkUnstructuredGrid* grid, vtkIdType cell, const PointReader& reader)
  {
    grid->GetCells()->GetCellAtId(cell, this->Ids);
    this->Points.resize(static_cast<std::size_t>(this->Ids->GetNumberOfIds()));
    for (std::size_t p = 0; p < this->Points.size(); ++p)
    {
      this->Points[p] = reader.Read(this->Ids->GetId(static_cast<vtkIdType>(p)));
    }
  }
};

struct Range
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();

  void Add(double value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }

  double Length() const { return std::max(this->High - this->Low, 0.0); }
};

/// Differences of a cell, not yet divided by anything.
struct CellError
{
  double OfPoints = 0.0, OfValues = 0.0;
  double Size = 0.0; ///< the diagonal of the box around its points
  Range Values;
};

/// The largest bound of all linear cells.
glm::dvec2 WorstOf(const std::vector<DivisionBound>& bounds, const std::vector<glm::dvec2>& off)
{
  glm::dvec2 worst(0.0);
  for (const DivisionBound& bound : bounds)
  {
    glm::dvec2 sum(0.0);
    for (const DivisionBound::Group& group : bound.Groups)
    {
      glm::dvec2 largest(0.0);
      for (const int check : group.Checks)
      {
        largest = glm::max(largest, off[static_cast<std::size_t>(check)]);
      }
      sum += group.Factor * largest;
    }
    worst = glm::max(worst, sum);
  }
  return worst;
}

/// Where the error is measured: first the points of divided cells of each kind, then the checks.
struct ErrorPlaces
{
  std::vector<std::vector<glm::dvec3>> Places;
  std::vector<DivisionChecks> Checks;

  ErrorPlaces(const CurvedCells& curved, int parts)
  {
    for (const CurvedKind& kind : curved.Kinds)
    {
      const CellDivision division = Divide(kind.Shape, parts);
      this->Places.push_back(PlacesOf(division));
      this->Checks.push_back(ChecksOf(division));
      for (const DivisionCheck& check : this->Checks.back().Checks)
      {
        this->Places.back().push_back(check.At);
      }
    }
  }

  CellError ErrorOf(
    std::uint32_t kind, const std::vector<PointValue>& points, const double* weights) const
  {
    CellError error;
    std::array<Range, 4> ranges;
    for (const PointValue& point : points)
    {
      for (std::size_t c = 0; c < 4; ++c)
      {
        ranges[c].Add(point[c]);
      }
    }
    error.Size = std::hypot(ranges[0].Length(), ranges[1].Length(), ranges[2].Length());
    error.Values = ranges[3];

    const DivisionChecks& checks = this->Checks[kind];
    const std::size_t count = this->Places[kind].size() - checks.Checks.size();
    std::vector<PointValue> divided(count);
    for (std::size_t p = 0; p < count; ++p)
    {
      divided[p] = Weigh(weights + p * points.size(), points);
    }
    std::vector<glm::dvec2> off(checks.Checks.size()); // of points and of values
    for (std::size_t i = 0; i < off.size(); ++i)
    {
      const PointValue truth = Weigh(weights + (count + i) * points.size(), points);
      const PointValue& a = divided[static_cast<std::size_t>(checks.Checks[i].Points[0])];
      const PointValue& b = divided[static_cast<std::size_t>(checks.Checks[i].Points[1])];
      PointValue difference;
      for (std::size_t c = 0; c < 4; ++c)
      {
        difference[c] = truth[c] - 0.5 * (a[c] + b[c]);
      }
      off[i] = { std::hypot(difference[0], difference[1], difference[2]), std::abs(difference[3]) };
    }
    const glm::dvec2 worst = WorstOf(checks.Bounds, off);
    error.OfPoints = worst.x;
    error.OfValues = worst.y;
    return error;
  }
};

/// Values that hardly differ in a cell are compared with this part of the range of all.
constexpr double SmallestRange = 0.01;

}

int OrderOf(const CurvedCells& curved)
{
  int order = 2;
  for (const CurvedKind& kind : curved.Kinds)
  {
    order = std::max(order, kind.Order);
  }
  return order;
}

CurvedError MeasureError(
  vtkUnstructuredGrid* grid, const CurvedCells& curved, const PointReader& reader, int parts)
{
  const ErrorPlaces places(curved, parts);
  const KindWeights weights(grid, curved, places.Places);
  std::vector<CellError> errors(curved.Cells.size());
  vtkSMPThreadLocal<Workplace> workplaces;
  vtkSMPTools::For(0, static_cast<vtkIdType>(curved.Cells.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      Workplace& work = workplaces.Local();
      for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
      {
        work.Read(grid, curved.Cells[c], reader);
        const double* rows = weights.Of(c, work.Cell, work.Own);
        errors[c] = places.ErrorOf(curved.KindOf[c], work.Points, rows);
      }
    });
  Range all;
  for (const CellError& error : errors)
  {
    all.Add(error.Values.Low);
    all.Add(error.Values.High);
  }
  CurvedError worst;
  for (const CellError& error : errors)
  {
    const double length = std::max(error.Values.Length(), SmallestRange * all.Length());
    worst.OfPoints = std::max(worst.OfPoints, error.Size > 0.0 ? error.OfPoints / error.Size : 0.0);
    worst.OfValues = std::max(worst.OfValues, length > 0.0 ? error.OfValues / length : 0.0);
  }
  return worst;
}

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

  const KindWeights weights(grid, curved, places);
  vtkSMPThreadLocal<Workplace> workplaces;
  vtkSMPTools::For(0, static_cast<vtkIdType>(curved.Cells.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      Workplace& work = workplaces.Local();
      for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
      {
        work.Read(grid, curved.Cells[c], reader);
        const double* rows = weights.Of(c, work.Cell, work.Own);
        for (std::size_t p = begins[c]; p < begins[c + 1]; ++p)
        {
          made.Points[first + p] =
            Weigh(rows + numbers.Places[p] * work.Points.size(), work.Points);
        }
      }
    });
}

}
