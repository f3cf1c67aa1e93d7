// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/CoarseImage.h"

#include "Files/Volume.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkTemporalCoherenceBrickSource.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr double MostSamples = 1 << 22; // in memory

// Each sample, or a few of them in equal distances. Nothing has the address of those that are read
// as they are needed.
vtkSmartPointer<vtkImageData> CopyOf(vtkImageData* image, vtkDataArray* samples)
{
  int dimensions[3], steps[3] = { 1, 1, 1 }, size[3];
  double spacing[3];
  image->GetDimensions(dimensions);
  image->GetSpacing(spacing);
  std::copy_n(dimensions, 3, size);
  while (1.0 * size[0] * size[1] * size[2] > MostSamples)
  {
    const auto longest = std::max_element(size, size + 3) - size;
    ++steps[longest];
    size[longest] = (dimensions[longest] - 1) / steps[longest] + 1;
  }
  const auto values =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(samples->GetDataType()));
  values->SetNumberOfTuples(static_cast<vtkIdType>(size[0]) * size[1] * size[2]);
  vtkIdType to = 0;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      const vtkIdType row = dimensions[0] *
        (static_cast<vtkIdType>(y) * steps[1] +
          dimensions[1] * static_cast<vtkIdType>(z) * steps[2]);
      for (int x = 0; x < size[0]; ++x)
      {
        values->SetTuple(to++, row + static_cast<vtkIdType>(x) * steps[0], samples);
      }
    }
  }
  const auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->SetDimensions(size);
  copy->SetOrigin(image->GetOrigin());
  copy->SetSpacing(spacing[0] * steps[0], spacing[1] * steps[1], spacing[2] * steps[2]);
  copy->GetPointData()->SetScalars(values);
  return copy;
}

}

vtkSmartPointer<vtkImageData> CoarseImageOf(vtkTemporalCoherenceBrickSource* bricks)
{
  vtkImageData* const image = bricks->GetOutput();
  vtkDataArray* const samples = image->GetPointData()->GetScalars();
  const bool isSmall = static_cast<double>(samples->GetNumberOfTuples()) <= MostSamples;
  vtkSmartPointer<vtkImageData> coarse = isSmall ? nullptr : bricks->GetCoarseImage();
  if (!coarse)
  {
    coarse = CopyOf(image, samples);
  }
  coarse->GetPointData()->GetScalars()->SetName(samples->GetName());
  return coarse;
}

vtkDataObject* SamplesInMemory(const Volume& volume)
{
  return volume.Coarse ? volume.Coarse.Get() : volume.Data.Get();
}

std::array<double, 2> RangeOf(const Volume& volume)
{
  auto* const image = vtkImageData::SafeDownCast(volume.Data);
  vtkDataArray* const samples = image->GetPointData()->GetScalars();
  vtkDataArray* const few = volume.Coarse->GetPointData()->GetScalars();
  // Those that are read in bricks know their range; an ordinary array may have been told it.
  const bool isKnown = !volume.Bricks->GetIsMapped() ||
    samples->GetInformation()->Has(vtkDataArray::PER_FINITE_COMPONENT());
  std::array<double, 2> range;
  (isKnown ? samples : few)->GetFiniteRange(range.data(), 0);
  const bool areAll = few->GetNumberOfTuples() == samples->GetNumberOfTuples();
  if (!isKnown && !areAll && samples->GetDataTypeSize() == 1)
  {
    samples->GetDataTypeRange(range.data());
  }
  return range;
}
