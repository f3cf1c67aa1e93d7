// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_WindowPicture_h
#define TemporalCoherence_WindowPicture_h

#include "Scene/View.h"
#include "Window/PixelRays.h"

#include <vector>

namespace TemporalCoherence
{

/// The value of the depth buffer for a hit at distance t: 0 at the near plane, 1 at the far plane.
float WindowDepthOf(const View& view, const glm::ivec2& pixel, double t);

/// A frame prepared for a window: the rectangle around all hits, row by row from below. Its pixels
/// are rays or, if rays outnumber the window's pixels, window pixels.
struct WindowPicture
{
  /// Prepare a frame.
  /// \param window pixels that the frame fills
  /// \throws std::bad_alloc
  void Assign(const Frame& frame, const View& view, const glm::ivec2& window);

  /// Mean colours of pixels, made of other colours of the rays.
  /// \param colors of the rays of Hits, row by row
  /// \pre it has fewer pixels than rays
  /// \throws std::bad_alloc
  std::vector<PixelColor> MeanColors(
    const Frame& frame, const std::vector<PixelColor>& colors) const;

  /// Hits begins and ends at multiples of this, in rays, and holds those of the last picture,
  /// unless that doubles it. So while the camera turns, most pictures have equally large textures,
  /// for which OpenGL needs no new memory.
  static constexpr int HitsGrain = 64;

  glm::ivec2 Size{ 0 };           ///< of the whole picture
  PixelRect Hits;                 ///< rays with all hits, and some around them; or empty
  PixelRect Rect;                 ///< the pixels that show them
  std::vector<PixelColor> Colors; ///< premultiplied; all 0 where nothing is hit
  std::vector<float> Depths; ///< in the depth buffer, of the first visible surfaces (PixelRays)
  bool HasOpaque = false;
  bool HasTranslucent = false; ///< some hits are translucent
  bool HasLayers = false;      ///< some pixels have several translucent layers
};

}

#endif
