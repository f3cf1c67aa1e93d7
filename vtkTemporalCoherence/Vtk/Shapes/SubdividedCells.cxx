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
Subdivision Plan(vtkUnstructuredGrid* grid, const CellsToReplace& cells, const PointReader& reader)
{
  Subdivision plan;
  plan.Curved = static_cast<std::int64_t>(cells.Curved.Cells.size());
  plan.Others = static_cast<std::int64_t>(cells.Others.size());
  if (cells.Curved.Cells.empty())
  {
    return plan;
  }
  // Errors shrink with the square of the number of parts: those of cells of order 2 exactly, others
  // once the parts are finer than the waves of the functions.
  const int order = OrderOf(cells.Curved);
  int measured = std::min(2 * (order - 1), MostParts);
  CurvedError error = MeasureError(grid, cells.Curved, reader, measured);
  const auto meetsGoal = [&]
  {
    if (order > 2 && plan.Parts > measured)
    {
      measured = plan.Parts;
      error = MeasureError(grid, cells.Curved, reader, measured);
    }
    const double factor = static_cast<double>(measured * measured) / (plan.Parts * plan.Parts);
    plan.ErrorOfPoints = factor * error.OfPoints;
    plan.ErrorOfValues = factor * error.OfValues;
    return std::max(plan.ErrorOfPoints, plan.ErrorOfValues) <= SubdivisionGoal;
  };
  while (!meetsGoal() && plan.Parts < MostParts &&
    CountCells(cells.Curved, plan.Parts + 1) <= MostSubdividedCells)
  {
    ++plan.Parts;
  }
  return plan;
}

std::string HaveTooMany(const GivenCells& given, const CellsToReplace& cells)
{
  return "There are " + std::to_string(cells.Curved.Cells.size()) + " curved cells and " +
    std::to_string(cells.Others.size()) + " polyhedra in " + given.Name +
    ", which are too many to be divided; draw parts of it, for example with vtkExtractCells, with "
    "a vtkVolume and a mapper each.";
}

}

bool IsSubdivided(int type)
{
  return IsCurved(type) || IsPolyhedron(type);
}

bool AppendSubdividedCells(const GivenCells& given, vtkDataArray* pointScalars, int component,
  const std::uint8_t* flags, std::uint8_t hidingFlags, std::vector<MeshPart>& parts,
  std::string& error, Subdivision* told)
{
  if (told)
  {
    *told = Subdivision();
  }
  CellsToReplace cells;
  if (!FindCells(given, flags, hidingFlags, cells, error))
  {
    return false;
  }
  if (cells.Curved.Cells.empty() && cells.Others.empty())
  {
    return true;
  }
  vtkUnstructuredGrid* const grid = given.Grid;
  const PointReader reader{ grid->GetPoints(), pointScalars, component };
  const Subdivision plan = Plan(grid, cells, reader);
  if (8 * CountCells(cells.Curved, plan.Parts) > MostMadeIds)
  {
    error = HaveTooMany(given, cells);
    return false;
  }
  const auto made = std::make_shared<MadeCells>();
  SharedPoints shared;
  DivideCurvedCells(grid, cells.Curved, reader, plan.Parts, shared, *made);
  PolyhedronCells others(given, reader, shared, *made);
  for (const vtkIdType cell : cells.Others)
  {
    if (!others.Add(cell, error))
    {
      return false;
    }
    if (made->Connectivity.size() > static_cast<std::size_t>(MostMadeIds) - (1 << 20))
    {
      error = HaveTooMany(given, cells);
      return false;
    }
  }
  parts.push_back(PartOf(made));
  if (told)
  {
    *told = plan;
  }
  return true;
}

}
