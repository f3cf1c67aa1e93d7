// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/MaskedTruth.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

namespace Masks
{

void Hide(vtkImageData* mask, const std::function<bool(double)>& isShown, BruteForceField& field)
{
  vtkDataArray* values = mask->GetPointData()->GetScalars();
  const int* count = mask->GetDimensions();
  const int nx = count[0], ny = count[1];
  field.HideBySamples([&](int i, int j, int k)
    { return isShown(values->GetComponent((k * ny + j) * static_cast<vtkIdType>(nx) + i, 0)); });
}

void Hide(vtkImageData* mask, BruteForceField& field)
{
  Hide(
    mask, [](double value) { return value > 0.0; }, field);
}

}
