// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/MadeFrom.h"

#include "Input/SamplesOfArray.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <string>

namespace TemporalCoherence
{

void MadeFrom::Add(vtkObject* object, vtkMTimeType time)
{
  this->Objects.emplace_back(object, object ? std::max(time, object->GetMTime()) : 0);
}

void MadeFrom::Add(vtkDataArray* array, vtkMTimeType time)
{
  this->Add(static_cast<vtkObject*>(array), time);
  if (!array)
  {
    return;
  }
  this->Add(static_cast<double>(array->GetNumberOfTuples()));
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    ArraySamples samples;
    std::string error;
    const bool areInPlace = FindSamples(array, component, samples, error);
    this->Places.push_back(areInPlace ? samples.First : nullptr);
  }
}

}
