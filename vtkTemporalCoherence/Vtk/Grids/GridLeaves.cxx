// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridLeaves.h"

#include "Adaptive/AmrGrids.h"
#include "Grids/CellTypes.h"
#include "Grids/GridShape.h"
#include "Input/BlockName.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// True for grids that are neither images nor rectilinear.
bool IsIrregular(vtkDataObject* data)
{
  return vtkUnstructuredGrid::SafeDownCast(data) || vtkStructuredGrid::SafeDownCast(data) ||
    vtkExplicitStructuredGrid::SafeDownCast(data);
}

vtkSmartPointer<vtkDataObjectTreeIterator> LeavesOf(vtkDataObjectTree* tree)
{
  return vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
}

/// False if all cells of a data set have fewer than three dimensions, as in vtkPolyData. Invalid
/// cells are reported later.
bool MayHaveVolume(vtkDataSet* data)
{
  if (vtkPolyData::SafeDownCast(data) || data->GetNumberOfCells() == 0)
  {
    return false;
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    vtkDataArray* types = TypesOf(grid);
    return !types || HaveVolume(types);
  }
  if (vtkExplicitStructuredGrid::SafeDownCast(data))
  {
    vtkCellArray* cells = CellsOf(data); // an empty grid counts cells without having any
    return cells && cells->GetNumberOfCells() > 0;
  }
  const glm::ivec3 dimensions = DimensionsOf(data);
  return dimensions == glm::ivec3(0) || glm::all(glm::greaterThan(dimensions, glm::ivec3(1)));
}

/// True for data sets that can be drawn, if they have cells with volume.
bool IsDrawn(vtkDataSet* data)
{
  return IsIrregular(data) || vtkImageData::SafeDownCast(data) ||
    vtkRectilinearGrid::SafeDownCast(data);
}

/// The data sets with volume, in the order of the tree.
bool FindDataSets(vtkDataObject* data, std::vector<GridLeaf>& leaves, std::string& error)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    auto* dataSet = vtkDataSet::SafeDownCast(data);
    if (MayHaveVolume(dataSet))
    {
      leaves.push_back({ dataSet, nullptr, false, 0, "The input" });
    }
    return true;
  }
  const auto leaf = LeavesOf(tree);
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* dataSet = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    if (dataSet && !MayHaveVolume(dataSet))
    {
      continue; // such as the patches of a boundary
    }
    if (!IsDrawn(dataSet))
    {
      error = NameOfLeaf(leaf) + " is a " + leaf->GetCurrentDataObject()->GetClassName() +
        ", but only blocks of images and of grids with cells can be drawn; leave it out with "
        "vtkExtractBlock.";
      return false;
    }
    leaves.push_back({ dataSet, nullptr, false, leaf->GetCurrentFlatIndex(), NameOfLeaf(leaf) });
  }
  return true;
}

}

bool IsMesh(vtkDataObject* data)
{
  if (AdaptiveGrid::SafeDownCast(data)) // since VTK 9.6 it is a tree, too
  {
    return true;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return IsIrregular(data);
  }
  const auto leaf = LeavesOf(tree);
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    if ((IsIrregular(block) || vtkRectilinearGrid::SafeDownCast(block)) && MayHaveVolume(block))
    {
      return true;
    }
  }
  return false;
}

bool FindLeaves(vtkDataObject* data, const ScalarChoice& choice, std::vector<GridLeaf>& leaves,
  std::string& error)
{
  leaves.clear();
  if (!FindDataSets(data, leaves, error) || leaves.empty())
  {
    return leaves.empty() && error.empty();
  }
  std::vector<vtkDataSet*> dataSets;
  for (const GridLeaf& leaf : leaves)
  {
    dataSets.push_back(leaf.Data);
  }
  const ScalarChoice same = ChoiceForAll(dataSets, choice);
  for (GridLeaf& leaf : leaves)
  {
    const ChosenScalars scalars = FindScalars(leaf.Data, same);
    leaf.Array = scalars.Array;
    leaf.OnCells = scalars.OnCells;
  }
  leaves.erase(
    std::remove_if(leaves.begin(), leaves.end(), [](const GridLeaf& leaf) { return !leaf.Array; }),
    leaves.end());
  if (leaves.empty())
  {
    error = WhyThereAreNoScalars(choice);
    return false;
  }
  return true;
}

}
