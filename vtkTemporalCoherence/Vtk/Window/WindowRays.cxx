// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/WindowRays.h"

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
    // Layers are merged with those of other volumes, which have no means of rays.
    distance = 1.0;
  }
  else if (asked < finest * (1.0 - rounding))
  {
    const glm::dvec2 rays = glm::dvec2(pixels) / asked;
    std::ostringstream what;
    what << "An ImageSampleDistance of " << asked << " asks for " << rays.x * rays.y
         << " rays in a window of " << pixels.x << " x " << pixels.y << " pixels, more than the "
         << MostRays << " that a frame may have; it is drawn with a distance of " << distance
         << ". Call SetImageSampleDistance with that or more, or make the window smaller.";
    told = what.str();
  }
  if (asked != this->LastAsked)
  {
    this->Warnings.clear();
    this->LastAsked = asked;
  }
  if (!told.empty() && this->Warnings.insert(told).second)
  {
    warning = told;
  }
  return RaysFor(pixels, distance);
}

}
