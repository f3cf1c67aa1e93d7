// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleDistance_h
#define TemporalCoherence_SampleDistance_h

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Rays along each axis of a picture of `pixels`; at least 1 if there are pixels.
/// \param distance if below 1, there are more rays than pixels
glm::ivec2 RaysFor(const glm::ivec2& pixels, double distance);

/// Limit of rays of a frame finer than its pixels: four for each pixel of 3840 x 2160. Two such
/// pictures take 2.4 GB.
constexpr double MostRays = 1 << 25;

/// The smallest distance, at most 1, at which a frame has at most MostRays.
double FinestDistance(const glm::ivec2& pixels);

}

#endif
