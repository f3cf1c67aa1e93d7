// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ToldChanges.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Numbers of a change: both stamps, and the extent.
constexpr std::size_t Numbers = 8;

/// More changes between two frames are not told apart from others.
constexpr std::size_t MostChanges = 256;

vtkInformationDoubleVectorKey* ChangesKey()
{
  static vtkInformationDoubleVectorKey* const key =
    vtkInformationDoubleVectorKey::MakeKey("TOLD_CHANGES", "vtkTemporalCoherenceVolumeMapper");
  return key;
}

/// As Field::Stamp.
vtkMTimeType StampOf(vtkImageData* image, vtkDataArray* array)
{
  return std::max(image->GetMTime(), array->GetMTime());
}

bool IsAmong(vtkDataSetAttributes* arrays, vtkDataArray* array)
{
  bool isAmong = false;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    isAmong |= array && arrays->GetAbstractArray(i) == array;
  }
  return isAmong;
}

std::vector<double> NumbersOf(vtkDataArray* array)
{
  if (!array->HasInformation() || !array->GetInformation()->Has(ChangesKey()))
  {
    return {};
  }
  const double* const numbers = array->GetInformation()->Get(ChangesKey());
  return { numbers, numbers + array->GetInformation()->Length(ChangesKey()) };
}

}

bool TellChange(vtkImageData* image, vtkDataArray* array, const std::array<int, 6>& extent)
{
  vtkDataArray* const ofPoints = image->GetPointData()->GetScalars();
  array = array ? array : ofPoints ? ofPoints : image->GetCellData()->GetScalars();
  const bool onCells = IsAmong(image->GetCellData(), array);
  if (!onCells && !IsAmong(image->GetPointData(), array))
  {
    return false;
  }
  const vtkMTimeType before = StampOf(image, array);
  std::vector<double> numbers = NumbersOf(array);
  if (numbers.size() == Numbers * MostChanges)
  {
    numbers.erase(numbers.begin(), numbers.begin() + Numbers);
  }
  vtkInformation* const about = array->GetInformation(); // may modify the array
  array->Modified();
  numbers.push_back(static_cast<double>(before));
  numbers.push_back(static_cast<double>(StampOf(image, array)));
  const int* const whole = image->GetExtent();
  for (std::size_t side = 0; side < extent.size(); ++side)
  {
    const int low = whole[side / 2 * 2];
    const int high = std::max(whole[side / 2 * 2 + 1] - (onCells ? 1 : 0), low);
    numbers.push_back(std::clamp(extent[side], low, high) - low);
  }
  about->Set(ChangesKey(), numbers.data(), static_cast<int>(numbers.size()));
  return true;
}

std::vector<SampleChange> ToldChanges(vtkDataArray* array)
{
  const std::vector<double> numbers = NumbersOf(array);
  std::vector<SampleChange> changes;
  for (std::size_t i = 0; i + Numbers <= numbers.size(); i += Numbers)
  {
    SampleChange change{ static_cast<std::uint64_t>(numbers[i]),
      static_cast<std::uint64_t>(numbers[i + 1]), {} };
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::size_t low = i + 2 + 2 * static_cast<std::size_t>(axis);
      change.Within.First[axis] = static_cast<int>(numbers[low]);
      change.Within.Last[axis] = static_cast<int>(numbers[low + 1]);
    }
    changes.push_back(change);
  }
  return changes;
}

}
