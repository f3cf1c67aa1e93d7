// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

#include "World/Arrays.h"
#include "World/Inputs.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUniformGrid.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace Fuzz
{
namespace Changes
{
namespace
{

void NewInput(World& world)
{
  Inputs::Show(world, world.IsOfMeshes ? Inputs::MakeMesh(world) : Inputs::MakeAny(world));
}

void EarlierInput(World& world)
{
  if (!world.Shelf.empty())
  {
    const int which = world.From.Pick(static_cast<int>(world.Shelf.size()));
    Inputs::Show(world, world.Shelf[static_cast<std::size_t>(which)]);
  }
}

/// The same lattice with a copy of the samples, some of them changed: the next time step.
void NextTimeStep(World& world)
{
  vtkImageData* image = world.Image();
  if (!image || image->GetNumberOfPoints() < 0 || image->GetNumberOfPoints() > 100000)
  {
    return;
  }
  const auto next = vtkSmartPointer<vtkImageData>::New();
  next->DeepCopy(image);
  vtkDataArray* scalars = next->GetPointData()->GetScalars();
  int dimensions[3];
  next->GetDimensions(dimensions);
  if (scalars && world.From.Pick(4) != 0)
  {
    Arrays::Rewrite(world, scalars, Arrays::PlacesOf(dimensions), false);
  }
  Inputs::Show(world, next);
}

/// Samples are written where they are.
void WriteSamples(World& world)
{
  vtkImageData* image = world.Image();
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfTuples() > 100000)
  {
    return;
  }
  int dimensions[3];
  image->GetDimensions(dimensions);
  Arrays::Rewrite(world, scalars, Arrays::PlacesOf(dimensions), world.From.OneIn(8));
  const int told = world.From.Pick(12);
  if (told == 11)
  {
    world.HasSilentChange = true; // see Acts
    Story::Tell("  nobody is told");
  }
  else
  {
    told % 2 ? image->Modified() : scalars->Modified();
  }
}

void WriteFewSamples(World& world)
{
  vtkImageData* image = world.Image();
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return;
  }
  for (int i = world.From.Pick(4); i >= 0; --i)
  {
    const vtkIdType at =
      world.From.Pick(static_cast<int>(std::min<vtkIdType>(scalars->GetNumberOfTuples(), 1 << 20)));
    const double value = world.From.Between(world.Low, world.High);
    scalars->SetComponent(at, 0, value);
    Story::Tell("  sample ", at, " is ", value);
  }
  scalars->Modified();
}

void MoveImage(World& world)
{
  vtkImageData* image = world.Image();
  if (!image)
  {
    return;
  }
  const double x = world.From.Number(-3.0, 3.0), y = world.From.Number(0.4, 2.0);
  if (world.From.OneIn(2))
  {
    image->SetOrigin(x, 0.0, 0.0);
    Story::Tell("  origin ", x);
  }
  else
  {
    image->SetSpacing(1.0, y, 1.0);
    Story::Tell("  spacing ", y);
  }
}

vtkDataSet* DataSetOf(World& world)
{
  vtkDataSet* data = vtkDataSet::SafeDownCast(world.Subject->GetDataObjectInput());
  return data ? data : world.Image();
}

void ChangeGhosts(World& world)
{
  vtkDataSet* data = DataSetOf(world);
  if (!data)
  {
    return;
  }
  const bool ofCells = world.From.OneIn(2);
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

/// Arrays are replaced, taken away, made longer or shorter below the mapper.
void ChangeArrays(World& world)
{
  Bytes& from = world.From;
  vtkDataSet* data = DataSetOf(world);
  if (!data || data->GetNumberOfPoints() < 0 || data->GetNumberOfPoints() > 100000)
  {
    return;
  }
  vtkPointData* points = data->GetPointData();
  vtkDataArray* scalars = points->GetScalars();
  switch (from.IsWild() ? from.Pick(6) : 0)
  {
    case 0:
    {
      const auto array = Arrays::Make(world, Arrays::PlacesOf(data, false));
      Arrays::Survey(world, array);
      points->SetScalars(array);
      break;
    }
    case 1:
      points->Initialize();
      Story::Tell("  the points have no arrays any more");
      break;
    case 2:
      if (scalars)
      {
        scalars->Resize(scalars->GetNumberOfTuples() / 2);
        scalars->Modified();
        Story::Tell("  half of the samples are gone");
      }
      break;
    case 3:
      if (scalars)
      {
        scalars->Initialize();
        scalars->Modified();
        Story::Tell("  all samples are gone");
      }
      break;
    case 4:
      points->SetActiveScalars(nullptr);
      Story::Tell("  no array is active");
      break;
    default:
      if (auto* image = vtkImageData::SafeDownCast(data))
      {
        image->SetDimensions(from.Pick(9), from.Pick(9), from.Pick(9));
        Story::Tell("  other dimensions: ", image->GetNumberOfPoints(), " points");
      }
      break;
  }
}

void ChangeCoordinates(World& world)
{
  auto* grid = vtkRectilinearGrid::SafeDownCast(world.Subject->GetDataObjectInput());
  vtkDataArray* along = grid ? grid->GetYCoordinates() : nullptr;
  if (along && along->GetNumberOfTuples() > 1)
  {
    const int last = static_cast<int>(along->GetNumberOfTuples()) - 1;
    const int at = world.From.Pick(last + 1);
    const double value =
      world.From.OneIn(2) ? along->GetComponent(at, 0) + 0.25 : world.From.Number(-5.0, 5.0);
    if (along->GetDataType() == VTK_DOUBLE)
    {
      along->SetComponent(at, 0, value);
      Story::Tell("  y coordinate ", at, " is ", value);
    }
  }
}

/// The mapper's reference is the last one.
void ForgetShelf(World& world)
{
  world.Shelf.clear();
}

void BlankSome(World& world)
{
  auto* grid = vtkUniformGrid::SafeDownCast(world.Image());
  if (grid && grid->GetNumberOfCells() > 0 && grid->GetNumberOfCells() < 100000)
  {
    const vtkIdType at = world.From.Pick(static_cast<int>(grid->GetNumberOfCells()));
    grid->BlankCell(at);
    grid->GetCellGhostArray()->Modified();
    Story::Tell("  cell ", at, " is blank");
  }
}

}

const std::vector<ChangeKind>& OfData()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "another input", { 8, 1, 1, 2, 1, 20, 2 }, NewInput },
    { "an earlier input", { 4, 1, 1, 6, 0, 4, 2 }, EarlierInput },
    { "the next time step", { 5, 1, 1, 40, 0, 2, 4 }, NextTimeStep },
    { "samples written in place", { 5, 0, 1, 20, 0, 4, 2 }, WriteSamples },
    { "few samples written in place", { 3, 1, 1, 40, 0, 1, 4 }, WriteFewSamples },
    { "the image moved", { 3, 0, 0, 2, 0, 5, 0 }, MoveImage },
    { "ghosts", { 4, 1, 1, 4, 1, 6, 2 }, ChangeGhosts },
    { "arrays", { 2, 0, 0, 1, 0, 12, 0 }, ChangeArrays },
    { "coordinates", { 2, 0, 0, 2, 0, 3, 1 }, ChangeCoordinates },
    { "data forgotten", { 1, 0, 0, 1, 0, 1, 0 }, ForgetShelf },
    { "a blank cell", { 1, 0, 0, 2, 0, 1, 1 }, BlankSome },
  };
  return kinds;
}

}
}
