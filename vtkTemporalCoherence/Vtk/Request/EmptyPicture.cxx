// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/EmptyPicture.h"

#include <vtkDataObject.h>
#include <vtkVolumeMapper.h>

#include <algorithm>

namespace TemporalCoherence
{

bool EmptyPicture::AreAllHidden(const Field& shown)
{
  if (!shown.Hidden)
  {
    return false;
  }
  if (this->Counted.lock() != shown.Hidden)
  {
    this->Counted = shown.Hidden;
    const glm::i64vec3 cells = glm::i64vec3(shown.Dimensions) - std::int64_t(1);
    this->WereAllHidden = shown.Hidden->Count() == cells.x * cells.y * cells.z;
  }
  return this->WereAllHidden;
}

std::string EmptyPicture::FindReason(
  vtkDataObject* data, bool isBlended, const Field& shown, const ValueRangePyramid& ranges)
{
  const bool isMesh = shown.Shape->Abilities().IsMesh;
  if (!shown.HasCells())
  {
    if (data->GetNumberOfElements(vtkDataObject::POINT) == 0)
    {
      return "The input has no samples; see that its source has data, or hide the vtkVolume with "
             "VisibilityOff.";
    }
    return isMesh ? "All cells of the input with volume are hidden by its ghost array "
                    "'vtkGhostType', or have no value that is a number; remove the flags, or "
                    "choose another array or time step."
                  : "";
  }
  if (ranges.WholeRange().x > ranges.WholeRange().y)
  {
    return "Every cell of the input has a sample that is NaN, which hides it; choose another array "
           "with SelectScalarArray, or another time step.";
  }
  if (this->AreAllHidden(shown))
  {
    return "All cells of the input are hidden by its ghost array 'vtkGhostType', a mask or samples "
           "that are NaN; remove the flags or the mask, or choose another array or time step.";
  }
  if (!shown.Shape->Abilities().HasVolume)
  {
    return "The points of each cell of the input lie in a plane, so that no cell has a volume; see "
           "that its source sets all coordinates of the points.";
  }
  if (isBlended && !ranges.HasFiniteSamples())
  {
    return "Every sample of the input is infinite, and blended volumes leave out cells with an "
           "infinite sample; choose another array with SelectScalarArray, or another time step.";
  }
  return "";
}

bool EmptyPicture::IsTold(const vtkVolume* volume) const
{
  return std::any_of(this->Stories.begin(), this->Stories.end(),
    [volume](const Story& story) { return story.Of.GetPointer() == volume; });
}

std::string EmptyPicture::Check(
  const DrawnVolume& drawn, const Field& shown, const ValueRangePyramid& ranges)
{
  vtkDataObject* data = drawn.Mapper->GetDataObjectInput();
  const bool isBlended = drawn.Mapper->GetBlendMode() != vtkVolumeMapper::ISOSURFACE_BLEND;
  const std::string reason = data ? this->FindReason(data, isBlended, shown, ranges) : "";
  this->Stories.erase(std::remove_if(this->Stories.begin(), this->Stories.end(),
                        [](const Story& story) { return !story.Of; }),
    this->Stories.end());
  const auto known = std::find_if(this->Stories.begin(), this->Stories.end(),
    [&](const Story& story) { return story.Of == drawn.Volume; });
  if (reason.empty())
  {
    if (known != this->Stories.end())
    {
      this->Stories.erase(known);
    }
    return "";
  }
  if ((known != this->Stories.end() && known->Reason == reason) || MaySeePartOnly(drawn))
  {
    return "";
  }
  if (known != this->Stories.end())
  {
    this->Stories.erase(known);
  }
  this->Stories.push_back({ drawn.Volume, reason });
  return "The picture is empty. " + reason;
}

}
