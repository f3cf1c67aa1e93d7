// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayBatch.h"

#include "KernelsRays.h"

namespace TemporalCoherence
{

RaySource::RaySource(const View& view, const Placement& placement, const glm::ivec3& dimensions)
  : Size(view.Size)
  , Last(dimensions - 1)
  , Near(view.Near)
  , Far(view.Far)
  , World{ view.Direction, view.DirectionX, view.DirectionY }
{
  const glm::dmat4& toIndex = placement.IndexFromWorld;
  const glm::dmat3 turn(toIndex);
  this->Direction = { turn * view.Direction, turn * view.DirectionX, turn * view.DirectionY };
  this->Origin = { glm::dvec3(toIndex * glm::dvec4(view.Origin, 1.0)), turn * view.OriginX,
    turn * view.OriginY };
  this->Forward = { glm::dot(view.Direction, view.Forward), glm::dot(view.DirectionX, view.Forward),
    glm::dot(view.DirectionY, view.Forward) };
}

void RaySource::SetUp(const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays) const
{
  SetUpRays(*this, first, size, rays);
}

void AppendRay(const RayBatch& from, std::size_t ray, RayBatch& to)
{
  const auto at = static_cast<std::size_t>(to.Count++);
  for (std::size_t a = 0; a < 3; ++a)
  {
    to.Origin[a][at] = from.Origin[a][ray];
    to.Direction[a][at] = from.Direction[a][ray];
    to.Inverse[a][at] = from.Inverse[a][ray];
  }
  to.PerDepth[at] = from.PerDepth[ray];
  to.Begin[at] = from.Begin[ray];
  to.End[at] = from.End[ray];
  to.WalkBegin[at] = from.WalkBegin[ray];
  to.WalkEnd[at] = from.WalkEnd[ray];
  to.Pixel[at] = from.Pixel[ray];
}

}
