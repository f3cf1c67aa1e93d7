// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/RayBatch.h"

#include "Scene/Tiles.h"

#include <cmath>

namespace TemporalCoherence
{

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
  to.MayBeCapped = from.MayBeCapped || (at > 0 && to.MayBeCapped);
}

double SpacingOf(const RayBatch& rays)
{
  constexpr std::size_t middle = 36, right = 7, above = 56;
  const double t = rays.WalkBegin[middle];
  glm::dvec3 direction, alongX, alongY;
  for (int a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<std::size_t>(a);
    const auto at = [&](std::size_t ray)
    { return rays.Origin[axis][ray] + t * rays.Direction[axis][ray]; };
    direction[a] = rays.Direction[axis][middle];
    alongX[a] = at(right) - at(0);
    alongY[a] = at(above) - at(0);
  }
  const double area = std::abs(glm::dot(direction, glm::cross(alongX, alongY)));
  return std::sqrt(area / glm::length(direction)) / (TileSize - 1);
}

}
