// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PixelRays_h
#define TemporalCoherence_PixelRays_h

#include "Scene/Frame.h"

#include <array>
#include <cstdint>
#include <optional>

namespace TemporalCoherence
{

/// RGBA.
using PixelColor = std::array<std::uint8_t, 4>;

/// Which rays of a frame a pixel of a window shows, where there are as many rays as pixels, fewer,
/// or more. Each ray stands for its share of the picture's area.
class PixelRays
{
public:
  PixelRays(const glm::ivec2& rays, const glm::ivec2& pixels)
    : Rays(rays)
    , Pixels(pixels)
  {
  }

  /// True if pixels show more rays than one.
  bool AreMore() const { return glm::any(glm::greaterThan(this->Rays, this->Pixels)); }

  /// The ray whose share holds the centre of a pixel.
  glm::ivec2 AtCentre(const glm::ivec2& pixel) const;

  /// All rays whose shares a pixel has a part of.
  PixelRect In(const glm::ivec2& pixel) const;

  /// The ray that tells where a pixel's surface is, in depth buffers and to picks: that at its
  /// centre; where that one misses, the one of its rays that hits nearest.
  /// \return none if they all miss
  std::optional<glm::ivec2> Shown(const Frame& frame, const glm::ivec2& pixel) const;

  /// The mean colour of a pixel's rays, weighted by the area that they have of it. It is opaque
  /// where they all are, and has an alpha other than 0 where any of them has.
  /// \param colors of the rays of `part`, row by row; others count as 0
  PixelColor MeanColor(
    const PixelColor* colors, const PixelRect& part, const glm::ivec2& pixel) const;

  /// All pixels that show a ray of a part of the frame.
  PixelRect PixelsOf(const PixelRect& part) const;

private:
  glm::ivec2 Rays, Pixels; ///< along each axis
};

}

#endif
