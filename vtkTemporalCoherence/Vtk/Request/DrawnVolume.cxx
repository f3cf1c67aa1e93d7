// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/DrawnVolume.h"

#include "Input/GhostArray.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>
#include <vtkVolumeMapper.h>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

bool HasFlag(vtkUnsignedCharArray* ghosts, int flag)
{
  return ghosts &&
    std::any_of(ghosts->GetPointer(0), ghosts->GetPointer(ghosts->GetNumberOfValues()),
      [=](unsigned char value) { return (value & flag) != 0; });
}

/// True if duplicate flags mark a data object as one of several pieces.
bool IsPiece(vtkDataObject* data)
{
  auto* dataSet = vtkDataSet::SafeDownCast(data);
  return dataSet &&
    (HasFlag(GhostsOf(dataSet->GetCellData()), vtkDataSetAttributes::DUPLICATECELL) ||
      HasFlag(GhostsOf(dataSet->GetPointData()), vtkDataSetAttributes::DUPLICATEPOINT));
}

/// True if blocks of a tree are missing, or are marked as pieces.
bool HasPieces(vtkDataObjectTree* tree)
{
  const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  leaf->SkipEmptyNodesOff();
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    vtkDataObject* block = leaf->GetCurrentDataObject();
    if (!block || IsPiece(block))
    {
      return true;
    }
  }
  return false;
}

/// True if the pipeline has more data than this image or grid.
bool IsPartOfPipeline(vtkInformation* pipeline, vtkDataObject* data)
{
  using Keys = vtkStreamingDemandDrivenPipeline;
  auto* image = vtkImageData::SafeDownCast(data);
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (!pipeline->Has(Keys::WHOLE_EXTENT()) || (!image && !grid))
  {
    return false;
  }
  const int* extent = image ? image->GetExtent() : grid->GetExtent();
  const int* whole = pipeline->Get(Keys::WHOLE_EXTENT());
  for (int axis = 0; axis < 3; ++axis)
  {
    if (extent[2 * axis] > whole[2 * axis] || extent[2 * axis + 1] < whole[2 * axis + 1])
    {
      return true;
    }
  }
  return false;
}

bool IsPropertyShared(vtkVolume* volume, vtkRenderer* renderer)
{
  vtkVolumeCollection* const volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator at;
  volumes->InitTraversal(at);
  while (vtkVolume* other = volumes->GetNextVolume(at))
  {
    if (other != volume && other->GetProperty() == volume->GetProperty())
    {
      return true;
    }
  }
  return false;
}

}

bool MaySeePartOnly(const DrawnVolume& drawn)
{
  vtkDataObject* data = drawn.Mapper->GetDataObjectInput();
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  // A mapper of blocks has its own mapper for each block.
  auto* owner = drawn.Volume->GetMapper();
  const bool isBlock = !tree && owner && owner != drawn.Mapper &&
    vtkCompositeDataSet::SafeDownCast(owner->GetDataObjectInput());
  return !data || isBlock || IsPiece(data) || (tree && HasPieces(tree)) ||
    IsPartOfPipeline(drawn.Mapper->GetInputInformation(0, 0), data) ||
    IsPropertyShared(drawn.Volume, drawn.Renderer);
}

}
