// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/MadeFrom.h"

#include "Input/SamplesOfArray.h"

#include <vtkDataArray.h>

#include <algorithm>

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
  const bool areInPlace = AreInPlace(array);
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    this->Places.push_back(areInPlace ? SamplesOf(array, component).First : nullptr);
  }
}

}
