// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridMesh.h"

#include "Adaptive/AmrMesh.h"
#include "Grids/AmrGrids.h"
#include "Shapes/SubdividedCells.h"

#include <vtkDataSet.h>
#include <vtkUniformGrid.h>
#include <vtkUniformGridAMR.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// A number that no other state of a mesh in this process has.
std::uint64_t NewStamp()
{
  static std::atomic<std::uint64_t> last(0);
  return ++last;
}

std::string CountText(std::int64_t count, const char* what)
{
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

bool HasSameNumbers(const MeshArray& a, const MeshArray& b, std::int64_t count)
{
  std::int64_t i = 0;
  while (i < count && a.At(i) == b.At(i))
  {
    ++i;
  }
  return i >= count;
}

/// True if parts that were made of the same data set differ in nothing but values.
bool HaveSameCells(const MeshPart& a, const MeshPart& b)
{
  return a.NumberOfCells == b.NumberOfCells && a.NumberOfPoints == b.NumberOfPoints &&
    a.ConnectivitySize == b.ConnectivitySize &&
    std::equal(a.Types, a.Types + a.NumberOfCells, b.Types) &&
    HasSameNumbers(a.Offsets, b.Offsets, a.NumberOfCells + 1) &&
    HasSameNumbers(a.Connectivity, b.Connectivity, a.ConnectivitySize) &&
    HasSameNumbers(a.Originals, b.Originals, a.NumberOfCells) &&
    HasSameNumbers(a.Coordinates[0], b.Coordinates[0], a.NumberOfPoints) &&
    HasSameNumbers(a.Coordinates[1], b.Coordinates[1], a.NumberOfPoints) &&
    HasSameNumbers(a.Coordinates[2], b.Coordinates[2], a.NumberOfPoints);
}

}

bool GridMesh::See(
  const std::vector<GridLeaf>& leaves, const DrawnComponent& component, std::string& error)
{
  Provenance now;
  for (const GridLeaf& leaf : leaves)
  {
    NoteCells(leaf, now.Cells);
    NotePoints(leaf, now.Points);
    NoteValues(leaf, component, now.Values);
  }
  const bool isMade = this->OfLeaves != nullptr && this->Parts.size() == leaves.size();
  this->AreCellsNew = !isMade || now.Cells != this->From.Cells;
  this->ArePointsNew = this->AreCellsNew || now.Points != this->From.Points;
  this->AreValuesNew = this->AreCellsNew || now.Values != this->From.Values;
  if (!this->ArePointsNew && !this->AreValuesNew)
  {
    return true;
  }
  this->OfLeaves = nullptr; // what follows may fail
  this->AreOthersNew = false;
  this->Parts.resize(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    if (!this->SeeLeaf(leaves[i], component, this->Parts[i], error))
    {
      return false;
    }
    this->Parts[i].AreValuesMade = this->Parts[i].Made.Values.Array != leaves[i].Array;
  }
  this->From = now;
  return this->Assemble(leaves, error);
}

bool GridMesh::SeeLeaf(
  const GridLeaf& leaf, const DrawnComponent& component, LeafPart& made, std::string& error)
{
  if (this->AreCellsNew)
  {
    made = LeafPart();
    if (!SetCells(leaf, made.Part, made.Made.Flags, made.Census, error))
    {
      return false;
    }
  }
  return (!this->ArePointsNew || SetPoints(leaf, made.Part, made.Made.Points, error)) &&
    (!this->AreValuesNew || SetValues(leaf, component, made.Part, made.Made.Values, error)) &&
    (!made.Census.HasOthers || this->SeeOthers(leaf, made, error));
}

/// Make linear cells of those that are not.
bool GridMesh::SeeOthers(const GridLeaf& leaf, LeafPart& made, std::string& error)
{
  const std::vector<MeshPart> last = std::move(made.Others);
  made.Others.clear();
  const PointValues& values = made.Made.Values;
  Subdivision division;
  const GivenCells cells(
    vtkUnstructuredGrid::SafeDownCast(leaf.Data), leaf.Block ? leaf.Name : "the input");
  if (!AppendSubdividedCells(cells, values.Array, values.Component, made.Part.Flags,
        made.Part.HidingFlags, made.Others, error, &division))
  {
    return false;
  }
  made.Error = { division.ErrorOfPoints, division.ErrorOfValues };
  // Into how many cells each one is divided depends on points and values. Weights and faces may
  // have changed, too: Modified() of the grid tells no more than that something did.
  const bool areSame = !this->ArePointsNew &&
    std::equal(last.begin(), last.end(), made.Others.begin(), made.Others.end(), HaveSameCells);
  this->AreOthersNew = this->AreOthersNew || !areSame;
  return true;
}

/// Make the mesh of its parts.
bool GridMesh::Assemble(const std::vector<GridLeaf>& leaves, std::string& error)
{
  const auto mesh = std::make_shared<Mesh>();
  std::vector<CellOrigins::Part> origins;
  std::int64_t first = 0, cells = 0;
  bool hasVolume = false;
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
    cells += leaves[i].Data->GetNumberOfCells();
    hasVolume = hasVolume || made.Census.HasVolume;
  }
  if (!hasVolume)
  {
    error = "The input has no cells with volume, but " + CountText(cells, "cell") +
      " of less than three dimensions; draw its contours with vtkContourFilter and "
      "vtkPolyDataMapper.";
    return false;
  }
  this->Stamp(*mesh);
  this->OfLeaves = mesh;
  this->OfCells = std::make_shared<CellOrigins>(mesh, std::move(origins));
  return true;
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

bool GridMesh::See(vtkUniformGridAMR* amr, const ScalarChoice& choice,
  const DrawnComponent& component, std::string& error)
{
  Provenance now;
  now.Cells.Add(amr);
  now.Cells.Add(choice.Mode);
  now.Cells.Add(component.IsMagnitude ? -1.0 : component.Number);
  ForEachGrid(amr,
    [&](vtkUniformGrid* grid)
    {
      const ChosenScalars scalars = FindScalars(grid, choice);
      now.Cells.Add(scalars.Array, grid->GetMTime());
    });
  if (this->OfLeaves && now.Cells == this->From.Cells)
  {
    return true;
  }
  this->Release();
  const auto mesh = std::make_shared<Mesh>();
  if (!AppendAmrMesh(
        amr, choice, component.IsMagnitude ? -1 : component.Number, mesh->Parts, error))
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
    largest.OfPoints = std::max(largest.OfPoints, part.Error.OfPoints);
    largest.OfValues = std::max(largest.OfValues, part.Error.OfValues);
  }
  return largest;
}

std::size_t GridMesh::MemoryInBytes() const
{
  std::size_t bytes = 0;
  const auto add = [&](const MeshPart& part)
  {
    bytes += static_cast<std::size_t>(part.NumberOfPoints) * 4 * sizeof(double) +
      static_cast<std::size_t>(part.ConnectivitySize + part.NumberOfCells) * sizeof(std::int32_t);
  };
  for (const LeafPart& made : this->Parts)
  {
    bytes += made.Made.Flags ? made.Made.Flags->size() : 0;
    bytes += made.Made.Points ? made.Made.Points->size() * sizeof(double) : 0;
    bytes += made.AreValuesMade
      ? static_cast<std::size_t>(made.Made.Values.Array->GetActualMemorySize()) << 10
      : 0;
    std::for_each(made.Others.begin(), made.Others.end(), add);
  }
  if (this->Parts.empty() && this->OfLeaves)
  {
    std::for_each(this->OfLeaves->Parts.begin(), this->OfLeaves->Parts.end(), add);
  }
  return bytes;
}

}
