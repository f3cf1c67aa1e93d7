// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/OneScalar.h"

#include "Files/Arrays.h"

#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

namespace
{

vtkSmartPointer<vtkDataArray> ComponentOf(vtkDataArray* array, int component)
{
  const auto scalar = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(component < 0 ? VTK_DOUBLE : array->GetDataType()));
  scalar->SetName("scalar");
  scalar->SetNumberOfTuples(array->GetNumberOfTuples());
  if (component >= 0)
  {
    scalar->CopyComponent(0, array, component);
    return scalar;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double sum = 0.0;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      sum += array->GetComponent(i, c) * array->GetComponent(i, c);
    }
    scalar->SetComponent(i, 0, std::sqrt(sum));
  }
  return scalar;
}

}

vtkSmartPointer<vtkDataSet> WithOneScalar(vtkDataSet* set, const ArrayChoice& choice, int component)
{
  vtkDataArray* const array = ArrayOf(set, choice);
  const vtkIdType count = choice.IsOnCells ? set->GetNumberOfCells() : set->GetNumberOfPoints();
  if (!array || array->GetNumberOfTuples() != count || count == 0 ||
    component >= array->GetNumberOfComponents())
  {
    return nullptr;
  }
  const auto scalar = ComponentOf(array, component);
  const auto copy = vtkSmartPointer<vtkDataSet>::Take(set->NewInstance());
  copy->CopyStructure(set);
  if (!choice.IsOnCells)
  {
    copy->GetPointData()->SetScalars(scalar);
    return copy;
  }
  copy->GetCellData()->SetScalars(scalar);
  vtkNew<vtkCellDataToPointData> average;
  average->SetInputData(copy);
  average->Update();
  return average->GetOutput();
}
