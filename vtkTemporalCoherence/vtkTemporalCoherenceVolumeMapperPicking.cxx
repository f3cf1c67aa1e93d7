// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Picks: in a pixel of the last frame, and along a line through the present volume.
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "SettingsFromMapper.h"
#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// \param to may be null
void CopyTo(double* to, const glm::dvec3& from)
{
  if (to)
  {
    std::copy_n(&from.x, 3, to);
  }
}

}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::PickPixel(
  int x, int y, double position[3], double normal[3], int* isovalueIndex)
{
  const TemporalCoherence::MapperFrames& frames = this->Internal->Frames;
  const auto hit = frames.FindHit(x, y);
  if (!hit)
  {
    return false;
  }
  CopyTo(position, hit->Position);
  CopyTo(normal, hit->Normal);
  if (isovalueIndex)
  {
    *isovalueIndex = frames.PlaceOf(hit->Surface);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::IntersectWithLine(vtkVolume* volume, const double p1[3],
  const double p2[3], double& t, double position[3], double normal[3], int* isovalueIndex)
{
  if (this->Internal->IsBusy("IntersectWithLine"))
  {
    return false;
  }
  if (!volume || !p1 || !p2)
  {
    this->Internal->ReportOnce(
      "IntersectWithLine needs a volume and two ends; one of them is null.");
    return false;
  }
  const glm::dvec3 begin(p1[0], p1[1], p1[2]), end(p2[0], p2[1], p2[2]);
  const double length = glm::distance(begin, end);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    std::ostringstream what;
    what << "There is no line from (" << p1[0] << ", " << p1[1] << ", " << p1[2] << ") to ("
         << p2[0] << ", " << p2[1] << ", " << p2[2] << "); give it two finite ends that differ.";
    this->Internal->ReportOnce(what.str());
    return false;
  }
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  TemporalCoherence::FrameRequest request;
  std::string error;
  std::optional<TemporalCoherence::LineHit> hit;
  if (this->Internal->Requests.Make(
        this, TemporalCoherence::SettingsOf(this), volume, {}, request, error))
  {
    hit = this->Internal->Frames.FindHit(request, begin, end, error);
  }
  this->Internal->ReportOnce(error);
  if (!hit)
  {
    return false;
  }
  t = hit->Distance / length;
  CopyTo(position, hit->Position);
  CopyTo(normal, hit->Normal);
  if (isovalueIndex)
  {
    *isovalueIndex = request.IsovaluePlaces[static_cast<std::size_t>(hit->Surface)];
  }
  return true;
}
VTK_ABI_NAMESPACE_END
