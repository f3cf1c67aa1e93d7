// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/SampleDistance.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{

glm::ivec2 RaysFor(const glm::ivec2& pixels, double distance)
{
  const glm::dvec2 rays = glm::dvec2(pixels) / distance;
  // A float such as 0.7f is a little less than 0.7.
  return distance < 1.0 ? glm::max(glm::ivec2(glm::round(rays)), pixels)
                        : glm::ivec2(glm::ceil(rays));
}

double FinestDistance(const glm::ivec2& pixels)
{
  return std::min(std::sqrt(static_cast<double>(pixels.x) * pixels.y / MostRays), 1.0);
}

}
