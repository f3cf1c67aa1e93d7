// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/SubdividedCells.h"

#include "Shapes/CurvedDivision.h"
#include "Shapes/CurvedError.h"
#include "Shapes/PolyhedronCells.h"

#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace TemporalCoherence
{
namespace
{

/// The cells of a grid that are to be replaced.
struct CellsToReplace
{
  CurvedCells Curved;
  std::vector<vtkIdType> Others;
};

bool FindCells(const GivenCells& given, const std::uint8_t* flags, std::uint8_t hidingFlags,
  CellsToReplace& cells, std::string& error)
{
  vtkUnstructuredGrid* const grid = given.Grid;
  CurvedCellFinder finder(given);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    if (!IsSubdivided(type) || (flags && (flags[cell] & hidingFlags) != 0))
    {
      continue;
    }
    if (!given.ReadPoints(cell, ids, error) || (IsCurved(type) && !finder.Add(cell, error)))
    {
      return false;
    }
    if (!IsCurved(type))
    {
      cells.Others.push_back(cell);
    }
  }
  cells.Curved = std::move(finder.Found);
  return true;
}

std::int64_t CountCells(const CurvedCells& curved, int parts)
{
  std::int64_t count = 0;
  for (const std::uint32_t kind : curved.KindOf)
  {
    count += CountDivisionCells(curved.Kinds[kind].Shape, parts);
  }
  return count;
}

/// How many parts the goal needs, within the limits.
/// \return false if progress stopped it
bool Plan(vtkUnstructuredGrid* grid, const CurvedCells& curved, const PointReader& reader,
  const ReportProgress& progress, Subdivision& plan)
{
  plan.Curved = static_cast<std::int64_t>(curved.Cells.size());
  if (curved.Cells.empty())
  {
    return true;
  }
  // Errors shrink with the square of the number of parts: those of cells of order 2 exactly, others
  // once the parts are finer than the waves of the functions.
  const int order = OrderOf(curved);
  int measured = std::min(2 * (order - 1), MostParts);
  CurvedError error;
  double begin = 0.0;
  const auto measure = [&]
  {
    const double end = 0.5 * (1.0 + begin); // nobody knows how often
    const bool isDone =
      MeasureError(grid, curved, reader, measured, PartOf(progress, begin, end), error);
    begin = end;
    return isDone;
  };
  bool isStopped = !measure();
  const auto meetsGoal = [&]
  {
    if (order > 2 && plan.Parts > measured)
    {
      measured = plan.Parts;
      isStopped = !measure();
    }
    const double factor = static_cast<double>(measured * measured) / (plan.Parts * plan.Parts);
    plan.ErrorOfPoints = factor * error.OfPoints;
    plan.ErrorOfValues = factor * error.OfValues;
    return std::max(plan.ErrorOfPoints, plan.ErrorOfValues) <= SubdivisionGoal;
  };
  while (!meetsGoal() && !isStopped && plan.Parts < MostParts &&
    CountCells(curved, plan.Parts + 1) <= MostSubdividedCells)
  {
    ++plan.Parts;
  }
  return !isStopped;
}

/// The memory of linear cells of curved ones, but not of their points.
std::size_t MemoryOfCells(const CurvedCells& curved, int parts)
{
  constexpr std::size_t bytesOfCell =
    sizeof(std::uint8_t) + sizeof(std::int32_t) + sizeof(std::int64_t);
  return static_cast<std::size_t>(CountCells(curved, parts)) * bytesOfCell +
    static_cast<std::size_t>(CountDivisionIds(curved, parts)) * sizeof(std::int32_t);
}

/// Shares of the progress that are reached with the plan, with the cells, and with their points.
constexpr double Planned = 0.3, Divided = 0.8, Placed = 0.9;

/// Make linear cells of the curved ones.
/// \return false if the budget does not do, or if it was stopped
bool MakeCurvedCells(vtkUnstructuredGrid* grid, const CurvedCells& curved,
  const PointReader& reader, int parts, MakingBudget& budget, SharedPoints& shared, MadeCells& made,
  CurvedPoints& points)
{
  const std::int64_t cells = CountCells(curved, parts);
  if (!budget.Allows(MemoryOfCells(curved, parts), cells))
  {
    return false;
  }
  made.Reserve(cells, CountDivisionIds(curved, parts));
  const ReportProgress whole = budget.Report;
  budget.Report = PartOf(whole, Planned, Divided);
  const bool areDivided = DivideCurvedCells(grid, curved, parts, budget, shared, made, points);
  budget.Report = whole;
  if (!areDivided)
  {
    return false;
  }
  made.Points.resize(points.Places.size());
  return PlaceCurvedPoints(
    grid, curved, reader, parts, points, PartOf(whole, Divided, Placed), made.Points.data());
}

std::string HaveTooMany(const GivenCells& given, const CellsToReplace& cells)
{
  return "There are " + std::to_string(cells.Curved.Cells.size()) + " curved cells and " +
    std::to_string(cells.Others.size()) + " polyhedra in " + given.Name +
    ", which are too many to be divided; draw parts of it, for example with vtkExtractCells, with "
    "a vtkVolume and a mapper each.";
}

/// Make linear cells of polyhedra.
/// \param error empty if the budget does not do, or if it was stopped
bool MakePolyhedra(const GivenCells& given, const CellsToReplace& cells, const PointReader& reader,
  MakingBudget& budget, SharedPoints& shared, MadeCells& made, std::string& error)
{
  constexpr std::size_t cellsBetweenReports = 256;
  PolyhedronCells others(given, reader, shared, made);
  for (std::size_t c = 0; c < cells.Others.size(); ++c)
  {
    if (!others.Add(cells.Others[c], error))
    {
      return false;
    }
    if (made.Connectivity.size() > static_cast<std::size_t>(MostMadeIds) - (1 << 20))
    {
      error = HaveTooMany(given, cells);
      return false;
    }
    const double share = static_cast<double>(c) / static_cast<double>(cells.Others.size());
    if (c % cellsBetweenReports == 0 &&
      (!budget.Allows(made.MemoryInBytes() + shared.MemoryInBytes(), made.NumberOfCells()) ||
        !budget.GoesOn(Placed + share * (1.0 - Placed))))
    {
      return false;
    }
  }
  return budget.Allows(made.MemoryInBytes(), made.NumberOfCells());
}

}

bool IsSubdivided(int type)
{
  return IsCurved(type) || IsPolyhedron(type);
}

bool AppendSubdividedCells(const GivenCells& given, vtkDataArray* pointScalars, int component,
  const std::uint8_t* flags, std::uint8_t hidingFlags, std::vector<MeshPart>& parts,
  std::string& error, Subdivision* told, MakingBudget* budget, KeptDivision* kept)
{
  MakingBudget unlimited;
  MakingBudget& limits = budget ? *budget : unlimited;
  Subdivision plan;
  CellsToReplace cells;
  if (!FindCells(given, flags, hidingFlags, cells, error))
  {
    return false;
  }
  vtkUnstructuredGrid* const grid = given.Grid;
  const PointReader reader{ grid->GetPoints(), pointScalars, component };
  if (!limits.GoesOn(0.0) ||
    !Plan(grid, cells.Curved, reader, PartOf(limits.Report, 0.0, Planned), plan))
  {
    return false;
  }
  plan.Others = static_cast<std::int64_t>(cells.Others.size());
  if (told)
  {
    *told = plan;
  }
  if (plan.Curved + plan.Others == 0)
  {
    return true;
  }
  if (8 * CountCells(cells.Curved, plan.Parts) > MostMadeIds)
  {
    error = HaveTooMany(given, cells);
    return false;
  }
  const auto made = std::make_shared<MadeCells>();
  SharedPoints shared;
  CurvedPoints points;
  if (!MakeCurvedCells(grid, cells.Curved, reader, plan.Parts, limits, shared, *made, points) ||
    !MakePolyhedra(given, cells, reader, limits, shared, *made, error))
  {
    return false;
  }
  const auto at = std::make_shared<const std::vector<PointValue>>(std::move(made->Points));
  made->Points.clear();
  parts.push_back(PartOf(made, at));
  if (kept && cells.Others.empty())
  {
    *kept = { std::move(cells.Curved), plan, std::move(points), made };
  }
  return true;
}

bool SetSubdividedValues(vtkUnstructuredGrid* grid, vtkDataArray* pointScalars, int component,
  const ReportProgress& progress, KeptDivision& kept, MeshPart& part, bool& isStopped)
{
  isStopped = false;
  if (!kept.Made)
  {
    return false;
  }
  const PointReader reader{ grid->GetPoints(), pointScalars, component };
  Subdivision plan;
  isStopped = !Plan(grid, kept.Curved, reader, PartOf(progress, 0.0, 0.5), plan);
  // More parts than are needed would do, too. But a picture must not tell what was drawn before.
  if (isStopped || plan.Parts != kept.Told.Parts)
  {
    return false;
  }
  const auto at = std::make_shared<std::vector<PointValue>>(kept.Points.Places.size());
  isStopped = !PlaceCurvedPoints(
    grid, kept.Curved, reader, plan.Parts, kept.Points, PartOf(progress, 0.5, 1.0), at->data());
  if (isStopped)
  {
    return false;
  }
  kept.Told = plan;
  part = PartOf(kept.Made, at);
  return true;
}

std::size_t KeptDivision::MemoryInBytes() const
{
  return this->Curved.Cells.size() * (sizeof(vtkIdType) + sizeof(std::uint32_t)) +
    this->Points.Begins.size() * sizeof(std::size_t) +
    this->Points.Places.size() * sizeof(std::uint16_t);
}

}
