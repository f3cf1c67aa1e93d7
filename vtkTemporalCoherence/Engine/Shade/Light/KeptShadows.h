// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KeptShadows_h
#define TemporalCoherence_KeptShadows_h

#include "Scene/FrameKey.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Keeps the hard shadows of the last frame, so that new colours of the same hits need no rays:
/// four bytes a pixel. Only of opaque surfaces, whose pixels have one hit each.
class KeptShadows
{
public:
  static constexpr std::size_t MostLights = 16; ///< shadows of further lights are not kept

  /// Begin a frame whose hits are shaded. What is kept is forgotten if the frame shows other hits,
  /// or if lights have moved.
  /// \param areHitsOfLast the frame has the hits of the frame before
  /// \return true if there is something to keep: opaque surfaces, and lights with hard shadows
  /// \throws std::bad_alloc
  bool Begin(const FrameKey& key, bool areHitsOfLast);

  /// Keep the shadows of the finished frame. Shadows of stopped frames are forgotten.
  void End() { this->IsWhole = true; }

  /// True if it is known whether a light reaches the hit of a pixel.
  /// \param light position in the appearance
  bool Knows(std::int32_t pixel, std::size_t light) const
  {
    return light < MostLights && (this->Bits[static_cast<std::size_t>(pixel)] >> light & 1u) != 0;
  }

  /// \pre Knows(pixel, light)
  bool IsLit(std::int32_t pixel, std::size_t light) const
  {
    return (this->Bits[static_cast<std::size_t>(pixel)] >> (MostLights + light) & 1u) != 0;
  }

  /// Thread-safe for different pixels.
  void Keep(std::int32_t pixel, std::size_t light, bool isLit)
  {
    if (light < MostLights)
    {
      this->Bits[static_cast<std::size_t>(pixel)] |= (isLit ? 0x10001u : 1u) << light;
    }
  }

private:
  std::vector<Light> Lights;       ///< of the last frame
  std::vector<std::uint32_t> Bits; ///< for each pixel: lights that are known, lights that reach it
  bool IsWhole = false;            ///< the last frame was made to its end
};

}

#endif
