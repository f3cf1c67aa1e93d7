// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleDistance_h
#define TemporalCoherence_SampleDistance_h

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Chooses how coarse frames have to be to keep to the time that they are given: the sample
/// distance is the pixels from one ray to the next along each axis.
///
/// It is a whole number where the limits are, or a whole part of a pixel, and changes rarely: a
/// frame of another size cannot use the one before again.
class SampleDistanceChooser
{
public:
  /// A frame is part of an interaction if it is given less time than this, in seconds; the limit of
  /// vtkFixedPointVolumeRayCastMapper.
  static constexpr double InteractiveTime = 1.0;

  /// Tell what a frame took whose rays were traced or looked up.
  ///
  /// What counts are frames of the same size as the one before, as others cannot use it again; and
  /// frames of interactions, as a still picture is completed once.
  /// \param size    rays along each axis
  /// \param seconds what making and showing it took
  /// \param allowed seconds that it was given
  void Learn(const glm::ivec2& size, double seconds, double allowed);

  /// The distance for the next frame.
  /// \param pixels  of the window
  /// \param allowed seconds that it is given
  /// \param current distance of the last frame
  /// \param limits  smallest and largest distance
  double Choose(
    const glm::ivec2& pixels, double allowed, double current, const glm::dvec2& limits) const;

private:
  double SecondsPerRay = 0.0; ///< 0 before the first frame
  glm::ivec2 LastSize{ 0 };
};

/// Rays along each axis of a picture of `pixels`; none only where there are no pixels.
/// \param distance below 1, there are more rays than pixels
glm::ivec2 RaysFor(const glm::ivec2& pixels, double distance);

/// Rays of a frame that is finer than the pixels, at most: four for each pixel of 3840 x 2160. Two
/// pictures with so many take 2.4 GB.
constexpr double MostRays = 1 << 25;

/// The least distance, at most 1, at which a frame has no more rays than that.
double FinestDistance(const glm::ivec2& pixels);

}

#endif
