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

/// Cells of a grid that linear cells replace.
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

/// Progress after the plan, after the cells, and after their points.
constexpr double Planned = 0.3, Divided = 0.8, Placed = 0.9;

/// Estimated memory of made cells, with the data that are kept for them.
std::size_t MemoryOf(const DivisionSize& size, std::size_t perCell)
{
  constexpr double bytesOfCell = sizeof(std::uint8_t) + sizeof(std::int32_t) + sizeof(std::int64_t);
  constexpr double bytesOfPoint = sizeof(PointValue) + sizeof(DivisionPlace);
  // Five or six tetrahedra have a point, and so has each hexahedron.
  const auto cells = static_cast<double>(size.Cells), ids = static_cast<double>(size.Ids);
  const double points = 0.25 * (ids - 4.0 * cells) + 0.18 * cells;
  return static_cast<std::size_t>(cells * (bytesOfCell + static_cast<double>(perCell)) +
    ids * sizeof(std::int32_t) + points * bytesOfPoint);
}

/// The division of curved cells, as fine as the goal and the budget allow.
class BudgetedPlan
{
public:
  BudgetedPlan(const CurvedSource& source, const MakingBudget& budget)
    : Of(source)
    , Budget(budget)
    , MostCells(std::clamp(MostCellsOfEach * static_cast<std::int64_t>(source.NumberOfCells()),
        MostCellsOfFew, MostSubdividedCells))
  {
  }

  /// \return false if progress stopped it
  bool Make(const ReportProgress& progress)
  {
    return this->Of.Measure(progress) && this->Choose(PartOf(progress, 1.0, 1.0));
  }

  /// Divide less, because the cells did not fit.
  /// \return false if all cells are whole, or if progress stopped it
  bool Coarsen(const ReportProgress& progress)
  {
    constexpr double step = 1.3;
    this->Limit = DivisionLimit::Memory;
    this->Goal *= step;
    return this->Of.IsDivided() && this->Choose(progress);
  }

  void Tell(Subdivision& told) const
  {
    const CurvedError error = this->Of.Error();
    told.Parts = this->Of.LargestParts();
    told.Error.OfPoints = error.OfPoints;
    told.Error.OfValues = error.OfValues;
    const double largest = std::max(error.OfPoints, error.OfValues);
    told.Error.Limit = this->Limit == DivisionLimit::Goal && largest > SubdivisionGoal
      ? DivisionLimit::Parts
      : this->Limit;
  }

  CurvedPlan Of;
  DivisionSize Size;

private:
  /// Choose the smallest error whose cells are few enough.
  bool Choose(const ReportProgress& progress)
  {
    for (;;)
    {
      this->Size = this->Of.Choose(this->Goal);
      double over = this->Excess();
      if (over <= 1.0 || !this->Of.IsDivided())
      {
        if (!this->Of.Join(progress, this->Size))
        {
          return false;
        }
        over = this->Excess();
      }
      if (over <= 1.0 || !this->Of.IsDivided())
      {
        return true;
      }
      // The number of cells is about proportional to error^(-3/2).
      constexpr double least = 1.05;
      this->Goal *= std::max(least, std::pow(over, 2.0 / 3.0));
    }
  }

  /// Ratio of the cells (or their memory) to the limit.
  double Excess()
  {
    const double ofCells =
      static_cast<double>(this->Size.Cells) / static_cast<double>(this->MostCells);
    const double ofMemory = static_cast<double>(MemoryOf(this->Size, this->Budget.PerCell)) /
      static_cast<double>(std::max<std::size_t>(this->Budget.ForDivision, 1));
    const double excess = std::max(ofCells, ofMemory);
    if (excess > 1.0)
    {
      this->Limit = ofMemory > ofCells ? DivisionLimit::Memory : DivisionLimit::Cells;
    }
    return excess;
  }

  const MakingBudget& Budget;
  std::int64_t MostCells;
  double Goal = SubdivisionGoal;
  DivisionLimit Limit = DivisionLimit::Goal;
};

/// Make the linear cells of curved ones.
/// \return false if the budget is too small, or if it was stopped
bool MakeCurvedCells(const CurvedSource& source, const BudgetedPlan& plan, MakingBudget& budget,
  SharedPoints& shared, MadeCells& made, CurvedPoints& points)
{
  if (!budget.Allows(MemoryOf(plan.Size, 0), plan.Size.Cells))
  {
    return false;
  }
  made.Reserve(plan.Size.Cells, plan.Size.Ids);
  const ReportProgress whole = budget.Report;
  budget.Report = PartOf(whole, Planned, Divided);
  const bool areDivided = DivideCurvedCells(source, plan.Of, budget, shared, made, points);
  budget.Report = whole;
  return areDivided;
}

/// Plan and make the linear cells of curved ones, without their points. If memory is too small, the
/// cells are divided less.
/// \return false if the budget is too small, or if it was stopped
bool MakeCurvedWithin(const CurvedSource& source, BudgetedPlan& plan, MakingBudget& budget,
  SharedPoints& shared, MadeCells& made, CurvedPoints& points)
{
  if (!plan.Make(PartOf(budget.Report, 0.0, Planned)))
  {
    return false;
  }
  for (;;)
  {
    MakingBudget trial = budget;
    if (MakeCurvedCells(source, plan, trial, shared, made, points))
    {
      return true;
    }
    if (!trial.IsTooSmall() || !plan.Coarsen({}))
    {
      budget.Allows(trial.NeededMemory(), 0);
      return false;
    }
    made = MadeCells();
    shared = SharedPoints();
    points = CurvedPoints();
  }
}

std::string HaveTooMany(const GivenCells& given, const CellsToReplace& cells)
{
  return "There are " + std::to_string(cells.Curved.Cells.size()) + " curved cells and " +
    std::to_string(cells.Others.size()) + " polyhedra in " + given.Name +
    ", which are too many to be divided; draw parts of it, for example with vtkExtractCells, with "
    "a vtkVolume and a mapper each.";
}

/// Make linear cells of polyhedra.
/// \param told  receives the polyhedra that are drawn beyond their faces
/// \param error empty if the budget is too small, or if it was stopped
bool MakePolyhedra(const GivenCells& given, const CellsToReplace& cells, const PointReader& reader,
  MakingBudget& budget, SharedPoints& shared, MadeCells& made, Subdivision& told,
  std::string& error)
{
  constexpr std::size_t cellsBetweenReports = 256;
  PolyhedronCells others(given, reader, shared, made);
  for (std::size_t c = 0; c < cells.Others.size(); ++c)
  {
    const std::int64_t searches = others.Searches;
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
    if ((c % cellsBetweenReports == 0 || others.Searches > searches) &&
      (!budget.Allows(made.MemoryInBytes() + shared.MemoryInBytes(), made.NumberOfCells()) ||
        !budget.GoesOn(Placed + share * (1.0 - Placed))))
    {
      return false;
    }
  }
  told.Error.Overlapping = static_cast<std::int64_t>(others.Overlapping.size());
  told.Error.Overlaps = others.Overlapping.empty() ? "" : given.NameOf(others.Overlapping.front());
  return budget.Allows(made.MemoryInBytes(), made.NumberOfCells());
}

}

bool IsSubdivided(int type)
{
  return IsCurved(type) || IsPolyhedron(type);
}

std::int64_t CountCurvedCells(vtkUnstructuredGrid* grid)
{
  std::int64_t count = 0;
  for (vtkIdType cell = 0; grid && cell < grid->GetNumberOfCells(); ++cell)
  {
    count += IsCurved(grid->GetCellType(cell)) ? 1 : 0;
  }
  return count;
}

bool AppendSubdividedCells(const GivenCells& given, vtkDataArray* pointScalars, int component,
  const std::uint8_t* flags, std::uint8_t hidingFlags, std::vector<MeshPart>& parts,
  std::string& error, Subdivision* told, MakingBudget* budget, KeptDivision* kept)
{
  MakingBudget unlimited;
  MakingBudget& limits = budget ? *budget : unlimited;
  Subdivision division;
  CellsToReplace cells;
  if (!FindCells(given, flags, hidingFlags, cells, error))
  {
    return false;
  }
  const PointReader reader{ given.Grid->GetPoints(), pointScalars, component };
  const CurvedSource source(given.Grid, cells.Curved, reader);
  division.Curved = static_cast<std::int64_t>(cells.Curved.Cells.size());
  division.Others = static_cast<std::int64_t>(cells.Others.size());
  if (!limits.GoesOn(0.0))
  {
    return false;
  }
  if (8 * division.Curved > MostMadeIds)
  {
    error = HaveTooMany(given, cells);
    return false;
  }
  const auto made = std::make_shared<MadeCells>();
  CurvedPoints points;
  BudgetedPlan plan(source, limits);
  {
    SharedPoints shared;
    if (!MakeCurvedWithin(source, plan, limits, shared, *made, points))
    {
      return false;
    }
    made->Points.resize(points.Places.size());
    if (!PlaceCurvedPoints(
          source, points, PartOf(limits.Report, Divided, Placed), made->Points.data()) ||
      !MakePolyhedra(given, cells, reader, limits, shared, *made, division, error))
    {
      return false;
    }
  }
  plan.Tell(division);
  if (told)
  {
    *told = division;
  }
  if (made->NumberOfCells() == 0)
  {
    return true;
  }
  const auto at = std::make_shared<const std::vector<PointValue>>(std::move(made->Points));
  made->Points.clear();
  parts.push_back(PartOf(made, at));
  if (kept && cells.Others.empty())
  {
    PartsOfCells chosen = plan.Of.Parts();
    *kept = { std::move(cells.Curved), division, std::move(chosen), std::move(points), made };
  }
  return true;
}

bool SetSubdividedValues(vtkUnstructuredGrid* grid, vtkDataArray* pointScalars, int component,
  const MakingBudget& budget, KeptDivision& kept, MeshPart& part, bool& isStopped)
{
  isStopped = false;
  if (!kept.Made)
  {
    return false;
  }
  const CurvedSource source(
    grid, kept.Curved, PointReader{ grid->GetPoints(), pointScalars, component });
  BudgetedPlan plan(source, budget);
  isStopped = !plan.Make(PartOf(budget.Report, 0.0, 0.5));
  // More parts than needed would suffice. But a picture must not depend on earlier frames.
  if (isStopped || plan.Of.Parts() != kept.Parts)
  {
    return false;
  }
  const auto at = std::make_shared<std::vector<PointValue>>(kept.Points.Places.size());
  isStopped = !PlaceCurvedPoints(source, kept.Points, PartOf(budget.Report, 0.5, 1.0), at->data());
  if (isStopped)
  {
    return false;
  }
  plan.Tell(kept.Told);
  part = PartOf(kept.Made, at);
  return true;
}

std::size_t KeptDivision::MemoryInBytes() const
{
  return this->Curved.Cells.capacity() * sizeof(vtkIdType) +
    this->Curved.KindOf.capacity() * sizeof(std::uint32_t) +
    this->Parts.capacity() * sizeof(std::uint16_t) + this->Points.MemoryInBytes();
}

}
