// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/RaySource.h"

#include "Lattice/KernelsRays.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

/// Fields at this distance in voxels or more are not drawn. The smallest step of a distance in
/// double precision is 2^-8 voxels there. Somewhat farther away, doubles cannot tell in which order
/// a ray passes cells.
constexpr double TooFar = 17592186044416.0; // 2^44

}

RaySource::RaySource(const View& view, const IndexTransform& transform,
  const glm::ivec3& dimensions, const Region& region)
  : Size(view.Size)
  , Last(dimensions - 1)
  , Near(view.Near)
  , Far(view.Far)
  , World{ view.Direction, view.DirectionX, view.DirectionY }
  , Clipper(region, transform)
{
  const glm::dmat4& toIndex = transform.IndexFromWorld;
  const glm::dmat3 turn(toIndex);
  this->Direction = { turn * view.Direction, turn * view.DirectionX, turn * view.DirectionY };
  this->Origin = { glm::dvec3(toIndex * glm::dvec4(view.Origin, 1.0)), turn * view.OriginX,
    turn * view.OriginY };
  this->Forward = { glm::dot(view.Direction, view.Forward), glm::dot(view.DirectionX, view.Forward),
    glm::dot(view.DirectionY, view.Forward) };
  const glm::dvec3 away = glm::abs(this->Origin[0]);
  if (!(std::max({ away.x, away.y, away.z }) < TooFar))
  {
    // Every ray is empty.
    this->Far = -std::numeric_limits<double>::infinity();
  }
}

void RaySource::SetUp(
  const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays, WorldDirections* world) const
{
  SetUpRays(*this, first, size, rays, world);
  if (!this->Clipper.IsWhole())
  {
    this->Clipper.Narrow(rays);
  }
}

void RaySource::SetUpAt(
  const RayPlaces& at, std::size_t count, RayBatch& rays, WorldDirections* world) const
{
  SetUpRaysAt(*this, at, rays, world);
  rays.Count = static_cast<int>(count);
  std::iota(rays.Pixel.begin(), rays.Pixel.end(), 0);
  if (count < RayBatch::Capacity)
  {
    rays.PerDepth.fill(0.0);
  }
  if (!this->Clipper.IsWhole())
  {
    this->Clipper.Narrow(rays);
  }
}

}
