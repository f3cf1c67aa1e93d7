// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleDistance_h
#define TemporalCoherence_SampleDistance_h

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Chooses how coarse frames must be to finish in their allowed time. The sample distance is the
/// number of pixels from one ray to the next along each axis.
///
/// The distance is an integer or, below 1, the inverse of one, if the limits permit. It changes
/// rarely, because frames of different sizes cannot re-use each other.
class SampleDistanceChooser
{
public:
  /// A frame is part of an interaction if its allowed time is less than this, in seconds: the limit
  /// of vtkFixedPointVolumeRayCastMapper.
  static constexpr double InteractiveTime = 1.0;

  /// Learn from a frame whose rays were traced or looked up.
  ///
  /// After the first frame, a frame counts only if it is part of an interaction and has the size of
  /// the frame before: a still picture is completed only once, and a frame of another size re-uses
  /// nothing.
  /// \param size    rays along each axis
  /// \param seconds to make and show it
  /// \param allowed seconds for it
  void Learn(const glm::ivec2& size, double seconds, double allowed);

  /// The distance for the next frame.
  /// \param pixels  of the window
  /// \param allowed seconds for the frame
  /// \param current distance of the last frame
  /// \param limits  smallest and largest distance
  double Choose(
    const glm::ivec2& pixels, double allowed, double current, const glm::dvec2& limits) const;

private:
  double SecondsPerRay = 0.0; ///< 0 before the first frame
  glm::ivec2 LastSize{ 0 };
};

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
