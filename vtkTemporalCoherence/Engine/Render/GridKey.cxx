// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/GridKey.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

FrameKey KeyOfGrid(const FrameKey& key, const glm::ivec2& rays)
{
  FrameKey fewer = key;
  const glm::ivec2 pixels = key.View.Size;
  fewer.View.Size = rays;
  if (key.IsBlended() && key.Blended().Ends)
  {
    // A ray of the grid takes the end of the pixel that contains it.
    const std::vector<double>& ends = *key.Blended().Ends;
    auto ofRays = std::make_shared<std::vector<double>>();
    ofRays->reserve(static_cast<std::size_t>(rays.x) * static_cast<std::size_t>(rays.y));
    const auto pixelAt = [](int ray, int of, int size)
    { return (2 * std::int64_t(ray) + 1) * size / (2 * std::int64_t(of)); };
    for (int y = 0; y < rays.y; ++y)
    {
      const std::int64_t row = pixelAt(y, rays.y, pixels.y) * pixels.x;
      for (int x = 0; x < rays.x; ++x)
      {
        ofRays->push_back(ends[static_cast<std::size_t>(row + pixelAt(x, rays.x, pixels.x))]);
      }
    }
    fewer.Blended().Ends = ofRays;
  }
  return fewer;
}

}
