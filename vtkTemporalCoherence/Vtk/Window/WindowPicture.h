// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_WindowPicture_h
#define TemporalCoherence_WindowPicture_h

#include "Scene/Frame.h"
#include "Scene/View.h"

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// RGBA.
using PixelColor = std::array<std::uint8_t, 4>;

/// What the depth buffer holds for a hit at distance t: 0 at the near plane, 1 at the far plane.
float WindowDepthOf(const View& view, const glm::ivec2& pixel, double t);

/// A frame as a window takes it: the rectangle with all its hits, row by row from below.
struct WindowPicture
{
  /// Take over a frame.
  /// \throws std::bad_alloc
  void Assign(const Frame& frame, const View& view);

  PixelRect Rect;                 ///< whole tiles; empty where nothing is hit
  std::vector<PixelColor> Colors; ///< premultiplied; all 0 where nothing is hit
  std::vector<float> Depths;      ///< of the depth buffer, of the surfaces seen first
  bool HasOpaque = false;
  bool HasTranslucent = false; ///< hits that let shine through what is behind them
  bool HasLayers = false;      ///< translucent surfaces behind one another
};

}

#endif
