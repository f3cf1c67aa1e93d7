// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ToldChanges.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// More changes between two frames are not told apart from others.
constexpr std::size_t MostChanges = 256;

/// The changes of an array, for its information: writers of files leave objects out.
class ChangeList : public vtkObject
{
public:
  static ChangeList* New();
  vtkTypeMacro(ChangeList, vtkObject);

  struct Entry
  {
    SampleChange Change;
    glm::ivec3 Dimensions; ///< samples of the image
  };
  std::vector<Entry> Entries; ///< oldest first

  /// The list of an array; null if there is none.
  static ChangeList* Of(vtkDataArray* array)
  {
    return array->HasInformation()
      ? ChangeList::SafeDownCast(array->GetInformation()->Get(ChangeList::Key()))
      : nullptr;
  }

  static vtkInformationObjectBaseKey* Key()
  {
    static vtkInformationObjectBaseKey* const key =
      vtkInformationObjectBaseKey::MakeKey("TOLD_CHANGES", "vtkTemporalCoherenceVolumeMapper");
    return key;
  }
};

vtkStandardNewMacro(ChangeList);

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

/// The samples of an image within an extent.
SampleBox BoxWithin(
  vtkImageData* image, const std::array<int, 6>& extent, const glm::ivec3& dimensions)
{
  SampleBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = image->GetExtent()[2 * axis];
    const auto low = static_cast<std::size_t>(2 * axis);
    // Differences of any two extents fit into 64 bits.
    const auto placeOf = [&](int at) { return static_cast<std::int64_t>(at) - first; };
    box.First[axis] =
      static_cast<int>(std::clamp<std::int64_t>(placeOf(extent[low]), 0, dimensions[axis]));
    box.Last[axis] = static_cast<int>(
      std::clamp<std::int64_t>(placeOf(extent[low + 1]), -1, dimensions[axis] - 1));
  }
  return box;
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
  vtkSmartPointer<ChangeList> list = ChangeList::Of(array);
  if (!list)
  {
    list = vtkSmartPointer<ChangeList>::New();
    array->GetInformation()->Set(ChangeList::Key(), list);
  }
  array->Modified();
  glm::ivec3 dimensions;
  image->GetDimensions(&dimensions.x);
  dimensions = onCells ? glm::max(dimensions - 1, 1) : dimensions;
  if (list->Entries.size() == MostChanges)
  {
    list->Entries.erase(list->Entries.begin());
  }
  list->Entries.push_back(
    { { before, StampOf(image, array), BoxWithin(image, extent, dimensions) }, dimensions });
  return true;
}

std::vector<SampleChange> ToldChanges(vtkDataArray* array, const glm::ivec3& dimensions)
{
  std::vector<SampleChange> changes;
  if (const ChangeList* const list = ChangeList::Of(array))
  {
    for (const ChangeList::Entry& entry : list->Entries)
    {
      if (entry.Dimensions == dimensions)
      {
        changes.push_back(entry.Change);
      }
    }
  }
  return changes;
}

}
