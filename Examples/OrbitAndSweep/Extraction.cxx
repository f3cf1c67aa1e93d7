// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Extraction.h"

#include "Files/Arrays.h"
#include "Files/OneScalar.h"
#include "Program/Silence.h"

#include <vtkContourFilter.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTimerLog.h>

namespace
{

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
  if (volume.Bricks)
  {
    return extraction; // it would read all samples
  }
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
