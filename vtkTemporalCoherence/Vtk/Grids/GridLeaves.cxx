// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridLeaves.h"

#include "Input/BlockName.h"

#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUniformGridAMR.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// Grids that are no images.
bool IsIrregular(vtkDataObject* data)
{
  return vtkUnstructuredGrid::SafeDownCast(data) || vtkStructuredGrid::SafeDownCast(data) ||
    vtkExplicitStructuredGrid::SafeDownCast(data);
}

bool IsBlock(vtkDataObject* data)
{
  return IsIrregular(data) || vtkImageData::SafeDownCast(data) ||
    vtkRectilinearGrid::SafeDownCast(data);
}

vtkSmartPointer<vtkDataObjectTreeIterator> LeavesOf(vtkDataObjectTree* tree)
{
  return vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
}

/// The data sets with cells, in the order of the tree.
bool FindDataSets(vtkDataObject* data, std::vector<GridLeaf>& leaves, std::string& error)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    auto* dataSet = vtkDataSet::SafeDownCast(data);
    if (dataSet->GetNumberOfCells() > 0)
    {
      leaves.push_back({ dataSet, nullptr, false, 0, "The input" });
    }
    return true;
  }
  const auto leaf = LeavesOf(tree);
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* dataSet = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    if (!IsBlock(dataSet) && !(dataSet && dataSet->GetNumberOfPoints() == 0))
    {
      error = NameOfLeaf(leaf) + " is a " + leaf->GetCurrentDataObject()->GetClassName() +
        ", but only blocks of images and of grids with cells can be drawn; leave it out with "
        "vtkExtractBlock.";
      return false;
    }
    if (dataSet->GetNumberOfCells() > 0)
    {
      leaves.push_back({ dataSet, nullptr, false, leaf->GetCurrentFlatIndex(), NameOfLeaf(leaf) });
    }
  }
  return true;
}

}

bool IsMesh(vtkDataObject* data)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return IsIrregular(data) || vtkUniformGridAMR::SafeDownCast(data);
  }
  const auto leaf = LeavesOf(tree);
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    vtkDataObject* block = leaf->GetCurrentDataObject();
    if (IsIrregular(block) || vtkRectilinearGrid::SafeDownCast(block))
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
