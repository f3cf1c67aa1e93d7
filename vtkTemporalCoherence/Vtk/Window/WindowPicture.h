// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_WindowPicture_h
#define TemporalCoherence_WindowPicture_h

#include "Scene/View.h"
#include "Window/PixelRays.h"

#include <vector>

namespace TemporalCoherence
{

/// What the depth buffer holds for a hit at distance t: 0 at the near plane, 1 at the far plane.
float WindowDepthOf(const View& view, const glm::ivec2& pixel, double t);

/// A frame as a window takes it: the rectangle with all its hits, row by row from below. There is a
/// pixel for each ray, or, where rays are more than the pixels of the window, for each of these.
struct WindowPicture
{
  /// Take over a frame.
  /// \param window pixels that the frame fills
  /// \throws std::bad_alloc
  void Assign(const Frame& frame, const View& view, const glm::ivec2& window);

  /// The colours of its pixels if those of the rays were others.
  /// \param colors of the rays of Hits, row by row
  /// \pre it has fewer pixels than rays
  /// \throws std::bad_alloc
  std::vector<PixelColor> MeanColors(
    const Frame& frame, const std::vector<PixelColor>& colors) const;

  glm::ivec2 Size{ 0 };           ///< of the whole picture
  PixelRect Hits;                 ///< whole tiles of rays with all hits; or empty
  PixelRect Rect;                 ///< the pixels that show them
  std::vector<PixelColor> Colors; ///< premultiplied; all 0 where nothing is hit
  std::vector<float> Depths;      ///< of the depth buffer, of the surfaces seen first (PixelRays)
  bool HasOpaque = false;
  bool HasTranslucent = false; ///< hits that let shine through what is behind them
  bool HasLayers = false;      ///< translucent surfaces behind one another
};

}

#endif
