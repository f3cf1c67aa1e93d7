// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeeledLayers_h
#define TemporalCoherence_PeeledLayers_h

#include "Window/WindowPicture.h"

#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// The layers at each pixel of a viewport, of one picture or several, from front to back up to the
/// first opaque one.
class PeeledLayers
{
public:
  /// A layer at a pixel.
  struct Layer
  {
    float Depth;      ///< of the depth buffer
    PixelColor Color; ///< its own, premultiplied
  };

  /// Remove all pictures.
  /// \param size pixels of the viewport
  void Clear(const glm::ivec2& size);

  /// Merge a picture with the present ones.
  /// \throws std::bad_alloc
  void Add(const Frame& frame, const View& view);

  const glm::ivec2& Size() const { return this->ViewportSize; }

  /// The layers of all pixels, row by row from below. Firsts holds where the layers of each pixel
  /// begin, and the end of the last.
  const std::vector<Layer>& All() const { return this->Layers; }
  const std::vector<std::size_t>& Begins() const { return this->Firsts; }

private:
  glm::ivec2 ViewportSize{ 0 };
  std::vector<Layer> Layers;
  std::vector<std::size_t> Firsts;
};

}

#endif
