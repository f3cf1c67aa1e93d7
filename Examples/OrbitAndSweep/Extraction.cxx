// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Extraction.h"

#include "Files/Arrays.h"
#include "Program/Silence.h"

#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkContourFilter.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTimerLog.h>

namespace
{

// The first component of what is drawn, at the points and without other arrays: the mapper takes
// arrays of several components and of cells, where VTK's filters read beyond their ends.
// Null if there is none.
vtkSmartPointer<vtkDataSet> WithOneScalar(vtkDataSet* set, const ArrayChoice& choice)
{
  vtkDataSetAttributes* from =
    choice.IsOnCells ? static_cast<vtkDataSetAttributes*>(set->GetCellData()) : set->GetPointData();
  vtkDataArray* array =
    choice.Name.empty() ? from->GetScalars() : from->GetArray(choice.Name.c_str());
  const vtkIdType count = choice.IsOnCells ? set->GetNumberOfCells() : set->GetNumberOfPoints();
  if (!array || array->GetNumberOfTuples() != count || count == 0)
  {
    return nullptr;
  }
  const auto scalar =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
  scalar->SetName("scalar");
  scalar->SetNumberOfTuples(count);
  scalar->CopyComponent(0, array, 0);
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

template <typename Filter>
void Time(vtkDataSet* set, double isovalue, Extraction& extraction)
{
  vtkNew<Filter> extract;
  extract->SetInputData(set);
  extract->SetValue(0, isovalue);
  extract->ComputeNormalsOn();
  extract->ComputeScalarsOff();
  const double begin = vtkTimerLog::GetUniversalTime();
  extract->Update();
  extraction.Ms += 1000.0 * (vtkTimerLog::GetUniversalTime() - begin);
  extraction.Triangles += extract->GetOutput()->GetNumberOfCells();
  extraction.Filter = extract->GetClassName();
}

}

Extraction TimeExtraction(const Volume& volume, double isovalue)
{
  const Silence silence; // filters tell of each flat cell
  Extraction extraction;
  extraction.Isovalue = isovalue;
  for (vtkDataSet* set : DataSetsOf(volume.Data))
  {
    const vtkSmartPointer<vtkDataSet> copy = WithOneScalar(set, volume.Array);
    if (copy && vtkImageData::SafeDownCast(volume.Data))
    {
      Time<vtkFlyingEdges3D>(copy, isovalue, extraction);
    }
    else if (copy)
    {
      Time<vtkContourFilter>(copy, isovalue, extraction);
    }
  }
  return extraction;
}
