// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/RegionFromMapper.h"

#include <vtkCollection.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkVolumeMapper.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Mirror a set of cropping boxes along an axis.
std::uint32_t Mirror(std::uint32_t boxes, int axis)
{
  const int step = axis == 0 ? 1 : axis == 1 ? 3 : 9;
  std::uint32_t mirrored = 0;
  for (int i = 0; i < 27; ++i)
  {
    const int place = i / step % 3;
    mirrored |= (boxes >> i & 1u) << (i + (2 - 2 * place) * step);
  }
  return mirrored;
}

bool FindClips(vtkVolumeMapper* mapper, Region& region, std::string& error)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  if (!planes)
  {
    return true;
  }
  vtkCollectionSimpleIterator at;
  planes->InitTraversal(at);
  while (vtkPlane* plane = planes->GetNextPlane(at))
  {
    const double* n = plane->GetNormal();
    const double* o = plane->GetOrigin();
    const glm::dvec4 clip(n[0], n[1], n[2], -(n[0] * o[0] + n[1] * o[1] + n[2] * o[2]));
    if (!std::isfinite(clip.x + clip.y + clip.z + clip.w))
    {
      std::ostringstream what;
      what << "Clipping plane " << region.Clips.size() << " has the normal (" << n[0] << ", "
           << n[1] << ", " << n[2] << ") and the origin (" << o[0] << ", " << o[1] << ", " << o[2]
           << "); give it finite numbers, or take it away with RemoveClippingPlane.";
      error = what.str();
      return false;
    }
    region.Clips.push_back(clip);
  }
  return true;
}

bool FindBoxes(vtkVolumeMapper* mapper, const ImageAxes& axes, Region& region, std::string& error)
{
  if (!mapper->GetCropping())
  {
    return true;
  }
  const double* planes = mapper->GetCroppingRegionPlanes();
  region.Boxes = static_cast<std::uint32_t>(mapper->GetCroppingRegionFlags()) & Region::AllBoxes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = axes.First[axis], step = axes.Step[axis];
    glm::dvec2& crops = region.Crops[static_cast<std::size_t>(axis)];
    crops = { (planes[2 * axis] - first) / step, (planes[2 * axis + 1] - first) / step };
    if (!std::isfinite(crops.x + crops.y))
    {
      std::ostringstream what;
      what << "The cropping planes along axis " << axis << " are at " << planes[2 * axis] << " and "
           << planes[2 * axis + 1]
           << "; set finite ones with SetCroppingRegionPlanes, or call CroppingOff.";
      error = what.str();
      return false;
    }
    if (step < 0.0)
    {
      std::swap(crops.x, crops.y);
      region.Boxes = Mirror(region.Boxes, axis);
    }
    crops.y = std::max(crops.x, crops.y);
  }
  return true;
}

}

bool MakeRegion(vtkVolumeMapper* mapper, const ImageAxes& axes, Region& region, std::string& error)
{
  region = Region();
  return FindClips(mapper, region, error) && FindBoxes(mapper, axes, region, error);
}

}
