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
vtkIdType vtkTemporalCoherenceVolumeMapper::PickCell(int x, int y, unsigned int* block)
{
  const TemporalCoherence::CellOrigin cell = this->Internal->Frames.FindCell(x, y);
  if (block && cell.Cell >= 0)
  {
    *block = cell.Block;
  }
  return cell.Cell;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::Internals::CanDraw(vtkVolume* volume)
{
  if (this->IsBusy("A pick"))
  {
    return false;
  }
  if (this->Self->GetNumberOfInputConnections(0) > 0)
  {
    this->Self->Update();
  }
  TemporalCoherence::FrameRequest request;
  std::string error;
  const bool isMade = this->Requests.Make(
    this->Self, TemporalCoherence::SettingsOf(this->Self), volume, {}, request, error);
  this->ReportOnce(error);
  return isMade && request.Key.Samples.HasCells();
}

//------------------------------------------------------------------------------
std::optional<vtkTemporalCoherenceVolumeMapper::Internals::FoundOnLine>
vtkTemporalCoherenceVolumeMapper::Internals::FindOnLine(
  vtkVolume* volume, const double p1[3], const double p2[3])
{
  if (this->IsBusy("IntersectWithLine"))
  {
    return std::nullopt;
  }
  if (!volume || !p1 || !p2)
  {
    this->ReportOnce("IntersectWithLine needs a volume and two points; one of them is null.");
    return std::nullopt;
  }
  const glm::dvec3 begin(p1[0], p1[1], p1[2]), end(p2[0], p2[1], p2[2]);
  const double length = glm::distance(begin, end);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    std::ostringstream what;
    what << "IntersectWithLine needs two different points with finite coordinates, got (" << p1[0]
         << ", " << p1[1] << ", " << p1[2] << ") and (" << p2[0] << ", " << p2[1] << ", " << p2[2]
         << ").";
    this->ReportOnce(what.str());
    return std::nullopt;
  }
  if (this->Self->GetNumberOfInputConnections(0) > 0)
  {
    this->Self->Update();
  }
  TemporalCoherence::FrameRequest request;
  std::string error;
  std::optional<TemporalCoherence::LineHit> hit;
  if (this->Requests.Make(
        this->Self, TemporalCoherence::SettingsOf(this->Self), volume, {}, request, error))
  {
    if (request.Key.IsBlended())
    {
      error = "IntersectWithLine finds isosurfaces only; call SetBlendModeToIsoSurface(), or pick "
              "in the last frame with PickPixel.";
      this->ReportOnce(error);
      return std::nullopt;
    }
    hit = this->Frames.FindHit(request, begin, end, error);
  }
  this->ReportOnce(error);
  if (!hit)
  {
    return std::nullopt;
  }
  return FoundOnLine{ *hit, request.IsovaluePlaces[static_cast<std::size_t>(hit->Surface)],
    request.Cells ? request.Cells->Of(hit->Cell) : TemporalCoherence::CellOrigin() };
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceVolumeMapper::IntersectWithLine(vtkVolume* volume, const double p1[3],
  const double p2[3], double& t, double position[3], double normal[3], int* isovalueIndex)
{
  const auto found = this->Internal->FindOnLine(volume, p1, p2);
  if (!found)
  {
    return false;
  }
  t = found->Hit.Distance /
    glm::distance(glm::dvec3(p1[0], p1[1], p1[2]), glm::dvec3(p2[0], p2[1], p2[2]));
  CopyTo(position, found->Hit.Position);
  CopyTo(normal, found->Hit.Normal);
  if (isovalueIndex)
  {
    *isovalueIndex = found->IsovaluePlace;
  }
  return true;
}
VTK_ABI_NAMESPACE_END
