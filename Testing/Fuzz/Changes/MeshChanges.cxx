// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

#include "World/Arrays.h"
#include "World/Inputs.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <random>

namespace Fuzz
{
namespace Changes
{
namespace
{

/// Any part of the input; null if there is none.
vtkDataSet* OneOfInput(World& world)
{
  const std::vector<vtkDataSet*> all = world.DataSets();
  return all.empty() ? nullptr
                     : all[static_cast<std::size_t>(world.From.Pick(static_cast<int>(all.size())))];
}

/// What is drawn of a data set; null if that is nothing.
vtkDataArray* ValuesOf(vtkDataSet* data, bool& onCells)
{
  vtkDataArray* ofPoints = data->GetPointData()->GetScalars();
  onCells = ofPoints == nullptr;
  return onCells ? data->GetCellData()->GetScalars() : ofPoints;
}

/// The same cells with other values: a time step.
void NextValues(World& world)
{
  vtkDataObject* data = world.Subject->GetDataObjectInput();
  auto* alone = vtkDataSet::SafeDownCast(data);
  bool onCells = false;
  vtkDataArray* values = alone ? ValuesOf(alone, onCells) : nullptr;
  if (!values)
  {
    return;
  }
  const auto next = vtkSmartPointer<vtkDataSet>::Take(alone->NewInstance());
  const bool sharesCells = !world.From.OneIn(4);
  sharesCells ? next->ShallowCopy(alone) : next->DeepCopy(alone);
  const auto other = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
  other->DeepCopy(values);
  if (world.From.Pick(4) != 0)
  {
    Arrays::Rewrite(world, other, Arrays::PlacesOf(alone, onCells), world.From.OneIn(4));
  }
  (onCells ? static_cast<vtkDataSetAttributes*>(next->GetCellData()) : next->GetPointData())
    ->SetScalars(other);
  Story::Tell(sharesCells ? "  of the same cells" : "  of a copy of the cells");
  Inputs::Show(world, next);
}

void WriteValues(World& world)
{
  vtkDataSet* data = OneOfInput(world);
  bool onCells = false;
  vtkDataArray* values = data ? ValuesOf(data, onCells) : nullptr;
  if (!values || values->GetNumberOfTuples() == 0)
  {
    return;
  }
  if (world.From.OneIn(3))
  {
    Arrays::Rewrite(world, values, Arrays::PlacesOf(data, onCells), world.From.OneIn(4));
  }
  else
  {
    const vtkIdType at = world.From.Pick(static_cast<int>(values->GetNumberOfTuples()));
    const double value = world.From.Between(world.Low, world.High);
    values->SetComponent(at, 0, value);
    Story::Tell("  value ", at, " is ", value);
  }
  values->Modified();
}

void MovePoints(World& world)
{
  auto* grid = vtkPointSet::SafeDownCast(OneOfInput(world));
  if (!grid || !grid->GetPoints() || grid->GetNumberOfPoints() == 0)
  {
    return;
  }
  std::mt19937 engine(static_cast<unsigned>(world.From.Next()));
  const double distances[] = { 0.05, 0.3, 0.0 };
  const double distance = world.From.OneOf(distances);
  const bool isOne = world.From.OneIn(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double at[3];
    grid->GetPoint(i, at);
    for (double& coordinate : at)
    {
      coordinate += distance * (static_cast<double>(engine()) / 2147483648.0 - 1.0);
    }
    if (!isOne || i == 0)
    {
      grid->GetPoints()->SetPoint(i, at);
    }
  }
  grid->GetPoints()->Modified();
  grid->Modified();
  Story::Tell(isOne ? "  a point" : "  all points", " by ", distance);
}

void HideCells(World& world)
{
  vtkDataSet* data = OneOfInput(world);
  if (!data)
  {
    return;
  }
  const bool ofCells = !world.From.OneIn(3);
  vtkDataSetAttributes* attributes =
    ofCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  if (world.From.OneIn(3))
  {
    attributes->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    Story::Tell("  ghost arrays are removed");
  }
  else
  {
    Arrays::AddGhosts(
      world, attributes, ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints());
  }
}

void AverageGradients(World& world)
{
  world.Subject->SetSmoothMeshNormals(world.From.Pick(2));
  Story::Tell("  averaged gradients ", world.Subject->GetSmoothMeshNormals());
}

/// More than a frame keeps of a pixel.
void ManyLayers(World& world)
{
  const double opacities[] = { 0.01, 0.03, 0.2 };
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(world.Low, world.From.OneOf(opacities));
  opacity->AddPoint(world.High, world.From.OneOf(opacities));
  world.Property()->SetScalarOpacity(opacity);
  const int many = 20 + world.From.Pick(30);
  const double step = (world.High - world.Low) / many, shift = world.From.Between(0.0, 1.0);
  std::vector<double> isovalues;
  for (int i = 0; i < many; ++i)
  {
    isovalues.push_back(world.Low + (i + shift) * step);
  }
  world.SetIsovalues(isovalues);
}

void LimitMemory(World& world)
{
  world.Subject->SetMeshMemoryLimit(world.From.IsWild() ? world.From.WildInt() : MeshMemory);
  Story::Tell("  memory of meshes ", world.Subject->GetMeshMemoryLimit());
}

}

const std::vector<ChangeKind>& OfManyLayers()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "many layers", { 8, 4, 8, 8, 8, 2, 20 }, ManyLayers },
  };
  return kinds;
}

const std::vector<ChangeKind>& OfMeshes()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "the next values of a mesh", { 6, 1, 1, 40, 0, 3, 4 }, NextValues },
    { "values of a mesh written in place", { 6, 1, 1, 40, 0, 3, 4 }, WriteValues },
    { "points of a mesh moved", { 4, 1, 1, 20, 0, 3, 2 }, MovePoints },
    { "ghosts of a mesh", { 3, 1, 1, 6, 0, 4, 2 }, HideCells },
    { "gradients of a mesh", { 3, 1, 2, 2, 4, 1, 4 }, AverageGradients },
    { "memory of a mesh", { 1, 1, 1, 1, 1, 6, 1 }, LimitMemory },
  };
  return kinds;
}

}
}
