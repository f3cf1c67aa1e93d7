// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/WindowRays.h"

#include "Render/SampleDistance.h"
#include "Window/PeelingPass.h"

#include <algorithm>
#include <sstream>

namespace TemporalCoherence
{

glm::ivec2 WindowRays::For(
  const glm::ivec2& pixels, double asked, vtkVolume* volume, std::string& warning)
{
  // Allow for rounding: the finest distance may be given as a rounded number or a float.
  constexpr double rounding = 1e-5;
  std::string told;
  const double finest = FinestDistance(pixels);
  double distance = std::max(asked, finest);
  if (asked < 1.0 && PeelingPass::Of(volume))
  {
    // Peeling merges the layers of several volumes, and knows no means of rays.
    distance = 1.0;
  }
  else if (asked < finest * (1.0 - rounding))
  {
    const glm::dvec2 rays = glm::dvec2(pixels) / asked;
    std::ostringstream what;
    what << "ImageSampleDistance " << asked << " needs "
         << static_cast<std::int64_t>(rays.x * rays.y) << " rays in a window of " << pixels.x
         << " x " << pixels.y << " pixels, but a frame has at most "
         << static_cast<std::int64_t>(MostRays) << "; the frame is drawn with " << distance
         << ". Call SetImageSampleDistance with at least that, or make the window smaller.";
    told = what.str();
  }
  if (asked != this->LastAsked)
  {
    this->HasWarned = false;
    this->LastAsked = asked;
  }
  if (!told.empty() && !this->HasWarned)
  {
    warning = told;
    this->HasWarned = true;
  }
  return RaysFor(pixels, distance);
}

}
