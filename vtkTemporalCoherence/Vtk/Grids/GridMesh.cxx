// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridMesh.h"

#include <vtkDataSet.h>

#include <atomic>

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
  this->Parts.resize(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    if (!this->SeeLeaf(leaves[i], component, this->Parts[i], error))
    {
      return false;
    }
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
    (!this->AreValuesNew || SetValues(leaf, component, made.Part, made.Made.Values, error));
}

/// Make the mesh of its parts.
bool GridMesh::Assemble(const std::vector<GridLeaf>& leaves, std::string& error)
{
  const auto mesh = std::make_shared<Mesh>();
  std::vector<CellOrigins::Part> origins;
  std::int64_t first = 0, cells = 0;
  bool hasVolume = false;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    LeafPart& made = this->Parts[i];
    made.Part.Owner = std::make_shared<Makings>(made.Made);
    mesh->Parts.push_back(made.Part);
    origins.push_back({ first, leaves[i].Data, leaves[i].Block });
    first += made.Part.NumberOfCells;
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
  this->CellStamp = this->AreCellsNew ? NewStamp() : this->CellStamp;
  this->PointStamp = this->ArePointsNew ? NewStamp() : this->PointStamp;
  this->ValueStamp = this->AreValuesNew ? NewStamp() : this->ValueStamp;
  mesh->CellStamp = this->CellStamp;
  mesh->PointStamp = this->PointStamp;
  mesh->ValueStamp = this->ValueStamp;
  this->OfLeaves = mesh;
  this->OfCells = std::make_shared<CellOrigins>(mesh, std::move(origins));
  return true;
}

}
