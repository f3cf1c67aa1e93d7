// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Masks.h"

#include <vtkDataArray.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkPointData.h>

#include <cmath>
#include <memory>
#include <random>

namespace Masks
{

vtkSmartPointer<vtkImageData> Make(const int count[3], int scalarType, const ChooseValue& value)
{
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->SetDimensions(count);
  mask->AllocateScalars(scalarType, 1);
  vtkDataArray* values = mask->GetPointData()->GetScalars();
  vtkIdType at = 0;
  for (int k = 0; k < count[2]; ++k)
  {
    for (int j = 0; j < count[1]; ++j)
    {
      for (int i = 0; i < count[0]; ++i, ++at)
      {
        values->SetComponent(at, 0, value(i, j, k));
      }
    }
  }
  return mask;
}

vtkSmartPointer<vtkImageData> For(vtkImageData* image, const ChooseValue& value, int scalarType)
{
  return Make(image->GetDimensions(), scalarType, value);
}

void SetBinary(vtkGPUVolumeRayCastMapper* mapper, vtkImageData* mask)
{
  mapper->SetMaskTypeToBinary();
  mapper->SetMaskInput(mask);
}

std::vector<Named> All()
{
  return {
    { "half", [](int i, int, int) { return i < 13 ? 255 : 0; } },
    { "blocks", [](int i, int j, int k) { return (i / 5 + j / 5 + k / 5) % 2; } },
    { "a sheet of one sample", [](int i, int, int) { return i == 14; } },
    { "few samples", Random(0.95, 1) },
    { "most samples", Random(0.3, 2) },
    { "a ball",
      [](int i, int j, int k) { return std::hypot(i - 15.5, j - 15.5, k - 15.5) < 11.0; } },
  };
}

ChooseValue Random(double chance, unsigned seed)
{
  const auto engine = std::make_shared<std::mt19937>(seed);
  return [=](int, int, int)
  {
    const bool isHidden = static_cast<double>((*engine)() % 1000u) < 1000.0 * chance;
    const int label = 1 + static_cast<int>((*engine)() % 3u);
    return isHidden ? 0 : label;
  };
}

}
