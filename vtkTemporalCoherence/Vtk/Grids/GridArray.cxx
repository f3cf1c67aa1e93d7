// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridArray.h"

#include "Adaptive/AmrMesh.h"
#include "Grids/PartPoints.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// The values of an array, which they own.
PartValues ValuesOf(vtkDataArray* array, const ArrayChoice& choice)
{
  PartValues values;
  values.AreOfCells = choice.OnCells;
  for (const int component : choice.ComponentsOf(array))
  {
    const ArraySamples samples = SamplesOf(array, component);
    values.Components.push_back({ samples.First, samples.Type, samples.Step });
  }
  values.Owners = { std::make_shared<const vtkSmartPointer<vtkDataArray>>(array) };
  return values;
}

/// Find values at the points of divided cells, each by the first cell with that point.
PartValues EvaluateCells(vtkDataSet* data, const PartValues& own, const MeshPart& part)
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  const auto count = static_cast<std::size_t>(part.NumberOfPoints);
  std::vector<std::shared_ptr<std::vector<double>>> made;
  PartValues found;
  while (made.size() < own.Components.size())
  {
    made.push_back(std::make_shared<std::vector<double>>(count, missing));
    found.Components.push_back({ made.back()->data(), ScalarType::Float64, 1 });
    found.Owners.push_back(made.back());
  }
  std::vector<bool> isMade(count);
  std::vector<double> weights;
  vtkNew<vtkGenericCell> original;
  std::int64_t last = -1;
  const auto evaluate = [&](std::int64_t cell, std::int64_t point)
  {
    if (cell != last)
    {
      last = cell;
      data->GetCell(cell, original);
      weights.resize(static_cast<std::size_t>(original->GetNumberOfPoints()));
    }
    double at[3], parametric[3], distance;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      at[axis] = part.Coordinates[axis].At(point);
    }
    int sub;
    if (original->EvaluatePosition(at, nullptr, sub, parametric, distance, weights.data()) < 0)
    {
      return; // the cell has no such place
    }
    for (std::size_t c = 0; c < made.size(); ++c)
    {
      double& value = (*made[c])[static_cast<std::size_t>(point)];
      value = 0.0;
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        value += weights[i] * own.Components[c].At(original->GetPointId(static_cast<int>(i)));
      }
    }
  };
  for (std::int64_t cell = 0; cell < part.NumberOfCells; ++cell)
  {
    ForEachPoint(part, cell,
      [&](std::int64_t point)
      {
        const auto place = static_cast<std::size_t>(point);
        if (!isMade[place])
        {
          isMade[place] = true;
          evaluate(part.Originals.First ? part.Originals.IdAt(cell) : cell, point);
        }
      });
  }
  return found;
}

}

/// \return true if values must be made again
bool GridArray::TakeNew(const MadeFrom& now, const Mesh& mesh)
{
  static std::atomic<std::uint64_t> last(0);
  if (now == this->From && mesh.CellStamp == this->OfCells && mesh.PointStamp == this->OfPoints &&
    !this->OfParts.empty())
  {
    return false;
  }
  this->From = now;
  this->OfCells = mesh.CellStamp;
  this->OfPoints = mesh.PointStamp;
  this->OfParts.clear();
  this->LastStamp = ++last;
  return true;
}

bool GridArray::See(const std::shared_ptr<const Mesh>& mesh, const CellOrigins& origins,
  const ArrayChoice& choice, std::string& error)
{
  this->Arrays.DropUnused();
  MadeFrom now;
  now.Add(choice.Component);
  now.Add(choice.OnCells);
  std::vector<CellOrigin> parts;
  std::vector<vtkDataArray*> arrays;
  while (parts.size() < mesh->Parts.size())
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
  }
  if (!this->TakeNew(now, *mesh))
  {
    return true;
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    // Parts of divided cells follow the one that has the data set's own points.
    const bool isDivided =
      i > 0 && parts[i].Data == parts[i - 1].Data && parts[i].Block == parts[i - 1].Block;
    const PartValues own = ValuesOf(arrays[i], choice);
    this->OfParts.push_back(
      isDivided && !choice.OnCells ? EvaluateCells(parts[i].Data, own, mesh->Parts[i]) : own);
  }
  return true;
}

bool GridArray::See(const std::shared_ptr<const Mesh>& mesh, AdaptiveGrid* amr,
  const ArrayChoice& choice, std::string& error)
{
  MadeFrom now;
  now.Add(amr);
  now.Add(choice.Component);
  bool isFound = choice.OnCells;
  std::vector<int> components;
  ForEachGrid(amr,
    [&](unsigned int, vtkImageData* grid)
    {
      vtkDataArray* const array = FindScalars(grid, choice.Scalars()).Array;
      now.Add(array, grid->GetMTime());
      isFound = isFound && array && HasComponent(array, choice, error);
      components = array ? choice.ComponentsOf(array) : components;
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
  if (!this->TakeNew(now, *mesh))
  {
    return true;
  }
  this->OfParts.resize(mesh->Parts.size());
  for (const int component : components)
  {
    std::vector<MeshPart> made;
    if (!AppendAmrMesh(amr, choice.Scalars(), component, made, error))
    {
      this->OfParts.clear();
      return false;
    }
    for (std::size_t i = 0; i < made.size(); ++i)
    {
      this->OfParts[i].Components.push_back(made[i].Values);
      this->OfParts[i].Owners.push_back(made[i].Owner);
    }
  }
  return true;
}

}
