// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridMesh.h"

#include "Adaptive/AmrGrids.h"
#include "Adaptive/AmrMesh.h"
#include "Input/SamplesOfArray.h"
#include "Shapes/SubdividedCells.h"

#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Divides the memory for divided cells among the leaves.
class DivisionShares
{
public:
  DivisionShares(const std::vector<GridLeaf>& leaves, const MakingBudget& budget)
    : IsLimited(budget.Memory < std::numeric_limits<std::size_t>::max())
  {
    for (std::size_t i = 0; i < leaves.size() && this->IsLimited; ++i)
    {
      this->ForTrees +=
        budget.PerCell * static_cast<std::size_t>(leaves[i].Data->GetNumberOfCells());
      this->Curved.push_back(CountCurvedCells(vtkUnstructuredGrid::SafeDownCast(leaves[i].Data)));
      this->Rest += this->Curved.back();
    }
  }

  /// The share of the next leaf.
  /// \param memory the remaining memory
  std::size_t Next(std::size_t memory)
  {
    if (!this->IsLimited)
    {
      return memory;
    }
    const auto own = static_cast<double>(this->Curved[this->At++]);
    const double share = own / static_cast<double>(std::max<std::int64_t>(this->Rest, 1));
    this->Rest -= static_cast<std::int64_t>(own);
    return static_cast<std::size_t>(
      share * static_cast<double>(memory - std::min(memory, this->ForTrees)));
  }

private:
  bool IsLimited;
  std::size_t At = 0, ForTrees = 0;
  std::int64_t Rest = 0;
  std::vector<std::int64_t> Curved;
};

bool HasSameNumbers(const MeshArray& a, const MeshArray& b, std::int64_t count)
{
  std::int64_t i = 0;
  while (i < count && a.At(i) == b.At(i))
  {
    ++i;
  }
  return i >= count;
}

/// True if two parts made of one data set differ in values at most: cells, points and original
/// cells are equal.
bool HaveSameCells(const MeshPart& a, const MeshPart& b)
{
  return a.NumberOfCells == b.NumberOfCells && a.NumberOfPoints == b.NumberOfPoints &&
    a.ConnectivitySize == b.ConnectivitySize &&
    std::equal(a.Types, a.Types + a.NumberOfCells, b.Types) && // made ones: one for each cell
    HasSameNumbers(a.Offsets, b.Offsets, a.NumberOfCells + 1) &&
    HasSameNumbers(a.Connectivity, b.Connectivity, a.ConnectivitySize) &&
    HasSameNumbers(a.Originals, b.Originals, a.NumberOfCells) &&
    HasSameNumbers(a.Coordinates[0], b.Coordinates[0], a.NumberOfPoints) &&
    HasSameNumbers(a.Coordinates[1], b.Coordinates[1], a.NumberOfPoints) &&
    HasSameNumbers(a.Coordinates[2], b.Coordinates[2], a.NumberOfPoints);
}

/// A new number, unique among all states of meshes in this process.
std::uint64_t NewStamp()
{
  static std::atomic<std::uint64_t> last(0);
  return ++last;
}

}

bool GridMesh::See(const std::vector<GridLeaf>& leaves, const DrawnComponent& component,
  MakingBudget& budget, std::string& error)
{
  Provenance now;
  for (const GridLeaf& leaf : leaves)
  {
    NoteCells(leaf, now.Cells);
    NotePoints(leaf, now.Points);
    NoteValues(leaf, component, now.Values);
  }
  const bool isMade = this->OfLeaves != nullptr && this->Parts.size() == leaves.size();
  // Under another limit, curved cells are divided differently.
  const bool isLimitNew = budget.Memory != this->Limit &&
    std::any_of(this->Parts.begin(), this->Parts.end(),
      [](const LeafPart& part) { return part.Census.HasOthers; });
  this->AreCellsNew = !isMade || isLimitNew || now.Cells != this->From.Cells;
  this->ArePointsNew = this->AreCellsNew || now.Points != this->From.Points;
  this->AreValuesNew = this->AreCellsNew || now.Values != this->From.Values;
  if (!this->ArePointsNew && !this->AreValuesNew)
  {
    return true;
  }
  this->OfLeaves = nullptr; // the next steps may fail
  this->AreOthersNew = false;
  this->Parts.resize(leaves.size());
  if (this->AreValuesNew && this->FindMissing(leaves, component))
  {
    this->AreCellsNew = this->ArePointsNew = true;
  }
  std::size_t all = this->MemoryInBytes();
  DivisionShares shares(leaves, budget);
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const auto share = [&](std::size_t leaf)
    { return static_cast<double>(leaf) / static_cast<double>(leaves.size()); };
    MakingBudget rest = budget;
    rest.Report = PartOf(budget.Report, share(i), share(i + 1));
    const std::size_t others = all - MemoryOf(this->Parts[i]);
    rest.Memory -= std::min(rest.Memory, others);
    rest.ForDivision = shares.Next(rest.Memory);
    if (!this->SeeLeaf(leaves[i], component, this->Parts[i], rest, error))
    {
      if (error.empty())
      {
        budget.Allows(rest.NeededMemory() + others, 0);
      }
      return false;
    }
    all = others + MemoryOf(this->Parts[i]);
    this->Parts[i].AreValuesMade = this->Parts[i].Made.Values.Array != leaves[i].Array;
  }
  this->From = now;
  this->Limit = budget.Memory;
  this->Assemble(leaves);
  return true;
}

/// Find cells without a value of their own.
/// \return true if they differ from the last ones, so that the tree does not fit
bool GridMesh::FindMissing(const std::vector<GridLeaf>& leaves, const DrawnComponent& component)
{
  bool areNew = false;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    std::vector<std::uint8_t> missing;
    FindMissingCells(leaves[i], component, missing);
    areNew |= missing != this->Parts[i].Missing;
    this->Parts[i].Missing = std::move(missing);
  }
  return areNew;
}

bool GridMesh::SeeLeaf(const GridLeaf& leaf, const DrawnComponent& component, LeafPart& made,
  MakingBudget& budget, std::string& error)
{
  if (this->AreCellsNew)
  {
    std::vector<std::uint8_t> missing = std::move(made.Missing);
    made = LeafPart();
    made.Missing = std::move(missing);
    if (!SetCells(
          leaf, made.Missing, made.Part, made.Made.Flags, made.Made.Cells, made.Census, error))
    {
      return false;
    }
  }
  return (!this->ArePointsNew || SetPoints(leaf, made.Part, made.Made.Points, error)) &&
    (!this->AreValuesNew || SetValues(leaf, component, made.Part, made.Made.Values, error)) &&
    (!made.Census.HasOthers || this->SeeOthers(leaf, made, budget, error));
}

/// Replace nonlinear cells by linear ones.
bool GridMesh::SeeOthers(
  const GridLeaf& leaf, LeafPart& made, MakingBudget& budget, std::string& error)
{
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data);
  bool isStopped = false;
  // Rational weights move points, and Modified() of the grid does not say what changed.
  const bool arePointsKept = !this->ArePointsNew && !grid->GetPointData()->GetRationalWeights();
  if (arePointsKept && !made.Others.empty() &&
    SetSubdividedValues(grid, made.Made.Values.Array, made.Made.Values.Component, budget, made.Kept,
      made.Others.front(), isStopped))
  {
    made.Error = made.Kept.Told.Error;
    return true;
  }
  if (isStopped)
  {
    return false;
  }
  const std::vector<MeshPart> last = std::move(made.Others);
  made.Others.clear();
  made.Kept = KeptDivision();
  const PointValues& values = made.Made.Values;
  Subdivision division;
  const GivenCells cells(grid, leaf.Block ? leaf.Name : "the input");
  if (!AppendSubdividedCells(cells, values.Array, values.Component, made.Part.Flags,
        made.Part.HidingFlags, made.Others, error, &division, &budget, &made.Kept))
  {
    return false;
  }
  made.Error = division.Error;
  // The division of each cell depends on points and values. Weights and faces may have changed,
  // too: Modified() of the grid does not say.
  const bool areSame = !this->ArePointsNew &&
    std::equal(last.begin(), last.end(), made.Others.begin(), made.Others.end(), HaveSameCells);
  this->AreOthersNew = this->AreOthersNew || !areSame;
  return true;
}

/// Make the mesh of its parts.
void GridMesh::Assemble(const std::vector<GridLeaf>& leaves)
{
  const auto mesh = std::make_shared<Mesh>();
  std::vector<CellOrigins::Part> origins;
  std::int64_t first = 0;
  const auto append = [&](const GridLeaf& leaf, const MeshPart& part)
  {
    mesh->Parts.push_back(part);
    origins.push_back({ first, leaf.Data, leaf.Block });
    first += part.NumberOfCells;
  };
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    LeafPart& made = this->Parts[i];
    made.Part.Owner = std::make_shared<Makings>(made.Made);
    append(leaves[i], made.Part);
    for (const MeshPart& other : made.Others)
    {
      append(leaves[i], other);
    }
  }
  this->Stamp(*mesh);
  this->OfLeaves = mesh;
  this->OfCells = std::make_shared<CellOrigins>(mesh, std::move(origins));
}

void GridMesh::Stamp(Mesh& mesh)
{
  const bool areCellsNew = this->AreCellsNew || this->AreOthersNew;
  this->CellStamp = areCellsNew ? NewStamp() : this->CellStamp;
  this->PointStamp = areCellsNew || this->ArePointsNew ? NewStamp() : this->PointStamp;
  this->ValueStamp = areCellsNew || this->AreValuesNew ? NewStamp() : this->ValueStamp;
  mesh.CellStamp = this->CellStamp;
  mesh.PointStamp = this->PointStamp;
  mesh.ValueStamp = this->ValueStamp;
}

bool GridMesh::See(AdaptiveGrid* amr, const ScalarChoice& choice, const DrawnComponent& component,
  MakingBudget& budget, std::string& error)
{
  Provenance now;
  now.Cells.Add(amr);
  now.Cells.Add(choice.Mode);
  now.Cells.Add(component.Key());
  bool haveComponent = true;
  ForEachGrid(amr,
    [&](unsigned int, vtkImageData* grid)
    {
      vtkDataArray* const array = FindScalars(grid, choice).Array;
      now.Cells.Add(array, grid->GetMTime());
      haveComponent = haveComponent &&
        (!array || component.IsMagnitude || HasComponent(array, component.Number, error));
    });
  if (!haveComponent)
  {
    return false;
  }
  if (this->OfLeaves && now.Cells == this->From.Cells)
  {
    return true;
  }
  this->Release();
  const auto mesh = std::make_shared<Mesh>();
  if (!AppendAmrMesh(
        amr, choice, component.IsMagnitude ? -1 : component.Number, mesh->Parts, error, &budget))
  {
    return false;
  }
  this->From = now;
  this->Stamp(*mesh);
  this->OfLeaves = mesh;
  return true;
}

DivisionError GridMesh::ErrorOfDivision() const
{
  DivisionError largest;
  for (const LeafPart& part : this->Parts)
  {
    largest.Add(part.Error);
  }
  return largest;
}

std::size_t GridMesh::MemoryOf(const MeshPart& made)
{
  const std::size_t bytesOfCell =
    sizeof(std::int32_t) + (made.Types ? 1 : 0) + (made.Originals.First ? sizeof(std::int64_t) : 0);
  return static_cast<std::size_t>(made.NumberOfPoints) * sizeof(PointValue) +
    static_cast<std::size_t>(made.ConnectivitySize) * sizeof(std::int32_t) +
    static_cast<std::size_t>(made.NumberOfCells) * bytesOfCell;
}

std::size_t GridMesh::MemoryOf(const LeafPart& made)
{
  std::size_t bytes = made.Kept.MemoryInBytes() + made.Missing.size();
  bytes += made.Made.Flags ? made.Made.Flags->size() : 0;
  bytes += made.Made.Points ? made.Made.Points->size() * sizeof(double) : 0;
  bytes += made.AreValuesMade
    ? static_cast<std::size_t>(made.Made.Values.Array->GetActualMemorySize()) << 10
    : 0;
  for (vtkDataArray* copy : made.Made.Cells)
  {
    bytes += static_cast<std::size_t>(copy->GetActualMemorySize()) << 10;
  }
  for (const MeshPart& other : made.Others)
  {
    bytes += MemoryOf(other);
  }
  return bytes;
}

std::size_t GridMesh::MemoryInBytes() const
{
  std::size_t bytes = 0;
  for (const LeafPart& made : this->Parts)
  {
    bytes += MemoryOf(made);
  }
  if (this->Parts.empty() && this->OfLeaves)
  {
    for (const MeshPart& made : this->OfLeaves->Parts)
    {
      bytes += MemoryOf(made);
    }
  }
  return bytes;
}

}
