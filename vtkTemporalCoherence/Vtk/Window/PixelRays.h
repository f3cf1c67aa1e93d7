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

/// Maps pixels of a window to rays of a frame. The numbers of both may differ. Each ray covers an
/// equal share of the picture's area.
class PixelRays
{
public:
  PixelRays(const glm::ivec2& rays, const glm::ivec2& pixels)
    : Rays(rays)
    , Pixels(pixels)
  {
  }

  /// True if pixels show several rays.
  bool AreMore() const { return glm::any(glm::greaterThan(this->Rays, this->Pixels)); }

  /// The ray whose area holds the centre of a pixel.
  glm::ivec2 AtCentre(const glm::ivec2& pixel) const;

  /// All rays whose areas overlap a pixel.
  PixelRect In(const glm::ivec2& pixel) const;

  /// The ray that locates a pixel's surface, for depth buffers and picks: the ray at its centre or,
  /// if that misses, the ray with the nearest hit.
  /// \return none if all rays miss
  std::optional<glm::ivec2> Shown(const Frame& frame, const glm::ivec2& pixel) const;

  /// The mean colour of a pixel's rays, weighted by their areas within the pixel. One translucent
  /// ray makes it translucent. Its alpha is 0 only if every ray's alpha is 0.
  /// \param colors of the rays of `part`, row by row; other rays count as 0
  PixelColor MeanColor(
    const PixelColor* colors, const PixelRect& part, const glm::ivec2& pixel) const;

  /// All pixels that show some ray of a part of the frame.
  PixelRect PixelsOf(const PixelRect& part) const;

private:
  glm::ivec2 Rays, Pixels; ///< along each axis
};

}

#endif
