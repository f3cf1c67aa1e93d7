// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PixelHit.h"

#include "Window/PixelRays.h"

namespace TemporalCoherence
{

std::optional<PixelHit> FindPixelHit(
  const Frame& frame, const View& view, const glm::ivec2& window, int x, int y)
{
  if (frame.IsEmpty() || x < 0 || y < 0 || x >= window.x || y >= window.y)
  {
    return std::nullopt;
  }
  const std::optional<glm::ivec2> ray = PixelRays(frame.Size, window).Shown(frame, { x, y });
  if (!ray)
  {
    return std::nullopt;
  }
  const std::size_t place = IndexOfPixel(frame, ray->x, ray->y);
  return PixelHit{ PositionOfHit(frame, view, ray->x, ray->y), glm::dvec3(frame.Normals[place]),
    frame.Isovalues[place], CellOfHit(frame, ray->x, ray->y) };
}

}
