// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/SampleDistance.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Frames get finer only with this safety factor on the distance, so that it does not oscillate.
/// (Part of the control loop, not tuned: TestUpdateRate.)
constexpr double ToSpare = 1.25;

/// The next integer or, below 1, the next inverse of one. 1/3 counts as such even if it was stored
/// as a float.
double Rounded(double distance)
{
  constexpr double shortest = 1e-9, close = 1e-6;
  return distance < 1.0 ? 1.0 / std::floor(1.0 / std::max(distance, shortest) + close)
                        : std::ceil(distance);
}

}

void SampleDistanceChooser::Learn(const glm::ivec2& size, double seconds, double allowed)
{
  const bool isTypical = size == this->LastSize && allowed < InteractiveTime;
  if (isTypical || this->SecondsPerRay == 0.0)
  {
    this->SecondsPerRay = seconds / (static_cast<double>(size.x) * size.y);
  }
  this->LastSize = size;
}

double SampleDistanceChooser::Choose(
  const glm::ivec2& pixels, double allowed, double current, const glm::dvec2& limits) const
{
  // The time of a frame is inversely proportional to the square of the distance.
  const double seconds = this->SecondsPerRay * pixels.x * pixels.y;
  const double needed = std::sqrt(seconds / std::max(allowed, 1e-9));
  const auto within = [&](double distance)
  { return std::min(std::max(Rounded(distance), limits.x), std::max(limits.x, limits.y)); };
  if (this->SecondsPerRay == 0.0)
  {
    return within(1.0);
  }
  const double next = within(needed);
  return next < current ? std::min(within(current), within(ToSpare * needed)) : next;
}

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
