// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/RegionClipper.h"

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Where a ray passes a plane across an axis.
double PassOf(const RayBatch& rays, std::size_t ray, std::size_t axis, double plane)
{
  return (plane - rays.Origin[axis][ray]) * rays.Inverse[axis][ray];
}

void Shorten(double begin, double end, std::size_t ray, RayBatch& rays)
{
  rays.Begin[ray] = std::max(rays.Begin[ray], begin);
  rays.End[ray] = std::min(rays.End[ray], end);
}

/// Shorten a ray to one side of a plane in index space.
void ShortenToSide(const glm::dvec4& plane, std::size_t ray, RayBatch& rays)
{
  double at = plane.w, slope = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    at += plane[static_cast<int>(a)] * rays.Origin[a][ray];
    slope += plane[static_cast<int>(a)] * rays.Direction[a][ray];
  }
  if (slope > 0.0)
  {
    Shorten(-at / slope, Infinity, ray, rays);
  }
  else if (slope < 0.0)
  {
    Shorten(-Infinity, -at / slope, ray, rays);
  }
  else if (at < 0.0)
  {
    Shorten(Infinity, -Infinity, ray, rays);
  }
}

}

RegionClipper::RegionClipper(const Region& region, const IndexTransform& transform)
  : ClipRegion(region)
  , IsConvex(region.IsConvex())
{
  for (const glm::dvec4& clip : region.Clips)
  {
    // Planes transform by the transposed matrix of the inverse. Then normalise.
    const glm::dvec4 plane = glm::transpose(transform.WorldFromIndex) * clip;
    const double length = glm::length(glm::dvec3(plane));
    this->Clips.push_back(length > 0.0 ? plane / length : plane);
  }
  this->AllPlanes = this->Clips;
  if (region.Boxes != Region::AllBoxes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        glm::dvec4 plane(0.0, 0.0, 0.0, -region.Crops[static_cast<std::size_t>(axis)][side]);
        plane[axis] = 1.0;
        this->AllPlanes.push_back(plane);
      }
    }
  }
}

void RegionClipper::Narrow(RayBatch& rays) const
{
  const bool isCropped = this->ClipRegion.Boxes != Region::AllBoxes;
  const BoxRange range = this->ClipRegion.RangeOfBoxes();
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    for (const glm::dvec4& clip : this->Clips)
    {
      ShortenToSide(clip, ray, rays);
    }
    for (std::size_t axis = 0; axis < 3 && isCropped; ++axis)
    {
      const auto a = static_cast<int>(axis);
      const glm::dvec2& planes = this->ClipRegion.Crops[axis];
      const double low = range.First[a] > 0 ? planes[std::min(range.First[a] - 1, 1)] : -Infinity;
      const double high = range.Last[a] < 2 ? planes[std::max(range.Last[a], 0)] : Infinity;
      const double toLow = PassOf(rays, ray, axis, low), toHigh = PassOf(rays, ray, axis, high);
      Shorten(std::min(toLow, toHigh), std::max(toLow, toHigh), ray, rays);
    }
    if (this->ClipRegion.Boxes == 0)
    {
      Shorten(Infinity, -Infinity, ray, rays);
    }
    rays.WalkBegin[ray] = std::max(rays.WalkBegin[ray], rays.Begin[ray]);
    rays.WalkEnd[ray] = std::min(rays.WalkEnd[ray], rays.End[ray]);
  }
}

RegionClipper::Pieces RegionClipper::PiecesOf(const RayBatch& rays, std::size_t ray) const
{
  Pieces pieces;
  const double begin = rays.Begin[ray], end = rays.End[ray];
  if (!(begin < end))
  {
    return pieces;
  }
  std::array<double, 8> stops{ begin };
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const double t = PassOf(rays, ray, axis, this->ClipRegion.Crops[axis][side]);
      if (t > begin && t < end)
      {
        // Insert in ascending order.
        std::size_t at = count++;
        for (; stops[at - 1] > t; --at)
        {
          stops[at] = stops[at - 1];
        }
        stops[at] = t;
      }
    }
  }
  stops[count++] = end;
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    const double middle = 0.5 * (stops[i] + stops[i + 1]);
    const glm::dvec3 point(rays.Origin[0][ray] + middle * rays.Direction[0][ray],
      rays.Origin[1][ray] + middle * rays.Direction[1][ray],
      rays.Origin[2][ray] + middle * rays.Direction[2][ray]);
    if (!(stops[i] < stops[i + 1]) || !this->Keeps(point))
    {
      continue;
    }
    if (pieces.Count > 0 && pieces.Ends[pieces.Count - 1].y == stops[i])
    {
      pieces.Ends[pieces.Count - 1].y = stops[i + 1];
    }
    else if (pieces.Count < MostPieces)
    {
      pieces.Ends[pieces.Count++] = { stops[i], stops[i + 1] };
    }
  }
  return pieces;
}

/// True if cropping keeps the box that holds a point.
bool RegionClipper::Keeps(const glm::dvec3& point) const
{
  int box = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const glm::dvec2& planes = this->ClipRegion.Crops[static_cast<std::size_t>(axis)];
    box = 3 * box + (point[axis] < planes.x ? 0 : point[axis] < planes.y ? 1 : 2);
  }
  return this->ClipRegion.Boxes >> box & 1u;
}

}
