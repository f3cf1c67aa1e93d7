// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridArray.h"

#include "Adaptive/AmrMesh.h"
#include "Grids/EvaluatedCells.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <cstddef>
#include <utility>

namespace TemporalCoherence
{
namespace
{

PartValues ValuesOf(vtkDataArray* array, const ArrayChoice& choice)
{
  PartValues values;
  values.AreOfCells = choice.OnCells;
  for (const int component : choice.ComponentsOf(array))
  {
    const ArraySamples samples = SamplesOf(array, component);
    values.Components.push_back({ samples.First, samples.Type, samples.Step });
  }
  return values;
}

/// Add a component of the array of an adaptive grid to the values of the parts of its mesh.
bool AddComponent(AdaptiveGrid* amr, const ArrayChoice& choice, int component, const Mesh& mesh,
  std::vector<PartValues>& made, std::string& error)
{
  std::vector<MeshPart> parts;
  if (!AppendAmrMesh(amr, choice.Scalars(), component, parts, error))
  {
    return false;
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (i >= made.size() || parts[i].NumberOfPoints != mesh.Parts[i].NumberOfPoints)
    {
      error = "The grids of the input that have array '" + choice.Name +
        "' are not those with the drawn array; give each grid both.";
      return false;
    }
    const auto values = std::make_shared<std::vector<double>>();
    for (std::int64_t point = 0; point < parts[i].NumberOfPoints; ++point)
    {
      values->push_back(parts[i].Values.At(point));
    }
    made[i].Components.push_back({ values->data(), ScalarType::Float64, 1 });
    made[i].Owners.push_back(values);
  }
  return true;
}

}

bool GridArray::IsKnown(const MadeFrom& now, const Mesh& mesh) const
{
  return !this->OfParts.empty() && now == this->From && mesh.CellStamp == this->OfCells &&
    mesh.PointStamp == this->OfPoints;
}

void GridArray::Take(std::vector<PartValues> parts, const MadeFrom& now, const Mesh& mesh)
{
  static std::atomic<std::uint64_t> last(0);
  this->OfParts = std::move(parts);
  this->From = now;
  this->OfCells = mesh.CellStamp;
  this->OfPoints = mesh.PointStamp;
  this->LastStamp = ++last;
}

bool GridArray::See(const Mesh& mesh, const CellOrigins& origins, const ArrayChoice& choice,
  std::vector<vtkSmartPointer<vtkObjectBase>>& read, std::string& error)
{
  this->Arrays.DropUnused();
  MadeFrom now;
  now.Add(choice.Component);
  now.Add(choice.OnCells);
  std::vector<CellOrigin> parts;
  std::vector<vtkDataArray*> arrays;
  while (parts.size() < mesh.Parts.size())
  {
    parts.push_back(origins.OfPart(parts.size()));
    vtkDataSet* const data = parts.back().Data;
    vtkDataArray* array = data ? FindScalars(data, choice.Scalars()).Array : nullptr;
    if (!array)
    {
      error = WhyThereIsNoArray(choice);
      return false;
    }
    array = this->Arrays.Of(array, data->GetMTime());
    const ArrayPlaces places = { "The input", choice.OnCells,
      choice.OnCells ? data->GetNumberOfCells() : data->GetNumberOfPoints() };
    if (!HasComponent(array, choice, error) || !CheckTuples(array, places, error))
    {
      return false;
    }
    now.Add(array, data->GetMTime());
    arrays.push_back(array);
    read.emplace_back(array);
  }
  if (this->IsKnown(now, mesh))
  {
    return true;
  }
  std::vector<PartValues> made;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    // Parts of divided cells follow the one that has the data set's own points.
    const bool isDivided =
      i > 0 && parts[i].Data == parts[i - 1].Data && parts[i].Block == parts[i - 1].Block;
    const PartValues own = ValuesOf(arrays[i], choice);
    made.push_back(
      isDivided && !choice.OnCells ? EvaluateCells(parts[i].Data, own, mesh.Parts[i]) : own);
  }
  this->Take(std::move(made), now, mesh);
  return true;
}

bool GridArray::See(
  const Mesh& mesh, AdaptiveGrid* amr, const ArrayChoice& choice, std::string& error)
{
  MadeFrom now;
  now.Add(amr);
  now.Add(choice.Component);
  bool isFound = choice.OnCells;
  bool areAlike = true;
  std::vector<int> components;
  ForEachGrid(amr,
    [&](unsigned int, vtkImageData* grid)
    {
      vtkDataArray* const array = FindScalars(grid, choice.Scalars()).Array;
      now.Add(array, grid->GetMTime());
      isFound = isFound && array && HasComponent(array, choice, error);
      const auto ofGrid = array ? choice.ComponentsOf(array) : components;
      areAlike = areAlike && (components.empty() || components == ofGrid);
      components = ofGrid;
    });
  if (!isFound)
  {
    error = !error.empty() ? error
      : choice.OnCells
      ? WhyThereIsNoArray(choice)
      : "An adaptive grid is drawn by the values of its cells, and so are its colours; call "
        "ColorArrayOnCellsOn().";
    return false;
  }
  if (!areAlike)
  {
    error = "Array '" + choice.Name +
      "' has different numbers of components in the grids of the "
      "input; choose one of them with SetColorArrayComponent.";
    return false;
  }
  if (this->IsKnown(now, mesh))
  {
    return true;
  }
  std::vector<PartValues> made(mesh.Parts.size());
  for (const int component : components)
  {
    if (!AddComponent(amr, choice, component, mesh, made, error))
    {
      return false;
    }
  }
  this->Take(std::move(made), now, mesh);
  return true;
}

}
