// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/SampleDistance.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Frames get finer only where that leaves so much of the time to spare along each axis, lest they
/// change to and fro. (A setting of the loop, not a tuned one: TestUpdateRate.)
constexpr double ToSpare = 1.25;

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
  // Seconds go with the square of the distance.
  const double seconds = this->SecondsPerRay * pixels.x * pixels.y;
  const double needed = std::sqrt(seconds / std::max(allowed, 1e-9));
  const auto within = [&](double distance)
  { return std::min(std::max(std::ceil(distance), limits.x), std::max(limits.x, limits.y)); };
  const double next = within(needed);
  return next < current ? std::min(within(current), within(ToSpare * needed)) : next;
}

glm::ivec2 RaysFor(const glm::ivec2& pixels, double distance)
{
  return glm::ivec2(glm::ceil(glm::dvec2(pixels) / std::max(distance, 1.0)));
}

}
