// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Output/PixelHit.h"

#include <algorithm>

namespace TemporalCoherence
{

std::optional<PixelHit> FindPixelHit(
  const Frame& frame, const View& view, const glm::ivec2& window, int x, int y)
{
  if (frame.IsEmpty() || x < 0 || y < 0 || x >= window.x || y >= window.y)
  {
    return std::nullopt;
  }
  if (frame.Size != window)
  {
    // A coarse frame: the ray that the pixel shows.
    const glm::dvec2 rays = (glm::dvec2(x, y) + 0.5) / glm::dvec2(window) * glm::dvec2(frame.Size);
    x = std::min(static_cast<int>(rays.x), frame.Size.x - 1);
    y = std::min(static_cast<int>(rays.y), frame.Size.y - 1);
  }
  const std::size_t pixel = IndexOfPixel(frame, x, y);
  if (frame.Isovalues[pixel] == Frame::NoSurface)
  {
    return std::nullopt;
  }
  return PixelHit{ PositionOfHit(frame, view, x, y), glm::dvec3(frame.Normals[pixel]),
    frame.Isovalues[pixel] };
}

}
