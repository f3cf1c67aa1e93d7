// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ImageValues.h"

#include "Input/FieldFromImage.h"
#include "Kinds/RectilinearKind.h"
#include "OutOfCore/VolumeOfArray.h"
#include "Shade/LatticeValues.h"

#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

namespace TemporalCoherence
{

namespace
{

/// True if all blocks with points have the array.
bool HaveAll(vtkDataObjectTree* tree, const ArrayChoice& choice, std::string& error)
{
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    auto* const block = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
    if (block && block->GetNumberOfCells() > 0 && !FindScalars(block, choice.Scalars()).Array)
    {
      error = WhyThereIsNoArray(choice);
      return false;
    }
  }
  return true;
}

}

bool ImageValues::Make(vtkDataObject* data, const ArrayChoice& choice, vtkVolume* volume,
  FoundValues& found, std::string& error)
{
  this->Arrays.DropUnused();
  auto* dataSet = vtkDataSet::SafeDownCast(data);
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(data))
  {
    if (!HaveAll(tree, choice, error) || !this->Blocks.Merge(tree, choice.Scalars(), error))
    {
      return false;
    }
    dataSet = this->Blocks.Image();
  }
  vtkDataArray* array = FindScalars(dataSet, choice.Scalars()).Array;
  if (!array)
  {
    error = WhyThereIsNoArray(choice);
    return false;
  }
  array = AreInBricks(array) ? array : this->Arrays.Of(array, dataSet->GetMTime());
  if (!HasComponent(array, choice, error))
  {
    return false;
  }
  auto* const grid = vtkRectilinearGrid::SafeDownCast(dataSet);
  if (grid && !this->Grid.See(grid, false, error))
  {
    return false;
  }
  vtkImageData* const image = grid ? this->Grid.Image() : vtkImageData::SafeDownCast(dataSet);
  LatticeArray made;
  if (!MakeIndexTransform(image, false, volume, made.Transform, error))
  {
    return false;
  }
  const Interpolation between =
    volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION
    ? Interpolation::Nearest
    : Interpolation::Linear;
  for (const int component : choice.ComponentsOf(array))
  {
    made.Components.emplace_back();
    if (!MakeField(image, array, choice.OnCells, component, made.Components.back(), error))
    {
      return false;
    }
    made.Components.back().Between = between;
  }
  made.IsOfCells = choice.OnCells;
  made.Grid = grid ? CoordinatesOf(*this->Grid.Shape()) : nullptr;
  found.Values = MakeLatticeValues(made);
  found.Read = { array };
  return true;
}

}
