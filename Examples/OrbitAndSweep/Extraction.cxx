// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Extraction.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTimerLog.h>

Extraction TimeExtraction(vtkImageData* image, double isovalue)
{
  vtkNew<vtkFlyingEdges3D> extract;
  extract->SetInputData(image);
  extract->SetValue(0, isovalue);
  extract->ComputeNormalsOn();
  extract->ComputeScalarsOff();
  const double begin = vtkTimerLog::GetUniversalTime();
  extract->Update();
  const double end = vtkTimerLog::GetUniversalTime();
  return { 1000.0 * (end - begin), extract->GetOutput()->GetNumberOfPolys(), isovalue };
}
