// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MergedMesh.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{

/// Copy the points and cells of a block, with the chosen arrays that it has and ghost flags of
/// both. Blocks without flags get empty ones: appending drops each array that some block lacks.
vtkSmartPointer<vtkDataSet> WithArrays(vtkDataSet* block, const std::vector<ArrayChoice>& choices)
{
  const auto copy = vtkSmartPointer<vtkDataSet>::Take(block->NewInstance());
  copy->CopyStructure(block);
  for (const ArrayChoice& choice : choices)
  {
    if (vtkDataArray* array = choice.In(block))
    {
      copy->GetAttributes(choice.IsOnCells ? vtkDataObject::CELL : vtkDataObject::POINT)
        ->AddArray(array);
    }
  }
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataArray* flags =
      block->GetAttributes(association)->GetArray(vtkDataSetAttributes::GhostArrayName());
    vtkNew<vtkUnsignedCharArray> none;
    if (!flags)
    {
      none->SetName(vtkDataSetAttributes::GhostArrayName());
      none->SetNumberOfTuples(block->GetNumberOfElements(association));
      none->Fill(0);
      flags = none;
    }
    copy->GetAttributes(association)->AddArray(flags);
  }
  return copy;
}

}

vtkSmartPointer<vtkUnstructuredGrid> Merge(
  vtkDataObject* blocks, const std::vector<ArrayChoice>& choices)
{
  const std::vector<vtkDataSet*> dataSets = DataSetsOf(blocks);
  const auto hasArray = [&](vtkDataSet* dataSet) { return choices.front().In(dataSet) != nullptr; };
  const bool isThere = std::any_of(dataSets.begin(), dataSets.end(), hasArray);
  vtkNew<vtkAppendFilter> append;
  bool isEmpty = true;
  for (vtkDataSet* dataSet : dataSets)
  {
    if (dataSet->GetNumberOfCells() > 0 && (!isThere || hasArray(dataSet)))
    {
      append->AddInputData(
        isThere ? WithArrays(dataSet, choices) : vtkSmartPointer<vtkDataSet>(dataSet));
      isEmpty = false;
    }
  }
  const auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (!isEmpty)
  {
    append->Update();
    mesh->ShallowCopy(append->GetOutput());
  }
  return mesh;
}
