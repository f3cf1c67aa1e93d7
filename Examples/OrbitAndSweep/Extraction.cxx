// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Extraction.h"

#include "Files/Arrays.h"

#include <vtkContourFilter.h>
#include <vtkDataObject.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTimerLog.h>

namespace
{

template <typename Filter>
Extraction Time(Filter* extract, const Volume& volume, double isovalue)
{
  const ArrayChoice& array = volume.Array;
  extract->SetInputDataObject(volume.Data);
  if (!array.Name.empty())
  {
    extract->SetInputArrayToProcess(0, 0, 0,
      array.IsOnCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                      : vtkDataObject::FIELD_ASSOCIATION_POINTS,
      array.Name.c_str());
  }
  extract->SetValue(0, isovalue);
  extract->ComputeNormalsOn();
  extract->ComputeScalarsOff();
  const double begin = vtkTimerLog::GetUniversalTime();
  extract->Update();
  const double end = vtkTimerLog::GetUniversalTime();
  vtkIdType triangles = 0;
  for (vtkDataSet* set : DataSetsOf(extract->GetOutputDataObject(0)))
  {
    triangles += set->GetNumberOfCells();
  }
  return { extract->GetClassName(), 1000.0 * (end - begin), triangles, isovalue };
}

}

Extraction TimeExtraction(const Volume& volume, double isovalue)
{
  return vtkImageData::SafeDownCast(volume.Data)
    ? Time(vtkNew<vtkFlyingEdges3D>().Get(), volume, isovalue)
    : Time(vtkNew<vtkContourFilter>().Get(), volume, isovalue);
}
