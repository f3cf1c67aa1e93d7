// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeeledLayers_h
#define TemporalCoherence_PeeledLayers_h

#include "Window/WindowPicture.h"

#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// The surfaces behind one another at each pixel of a viewport, of one picture or of several, from
/// front to back as far as something shines through.
class PeeledLayers
{
public:
  /// A surface at a pixel.
  struct Layer
  {
    float Depth;      ///< of the depth buffer
    PixelColor Color; ///< its own, premultiplied
  };

  /// Forget all pictures.
  /// \param size pixels of the viewport
  void Clear(const glm::ivec2& size);

  /// Lay a picture among those that are there.
  /// \throws std::bad_alloc
  void Add(const Frame& frame, const View& view);

  const glm::ivec2& Size() const { return this->ViewportSize; }

  /// The layers of all pixels, one after the other, row by row from below; and where those of each
  /// pixel begin, with the end of the last one.
  const std::vector<Layer>& All() const { return this->Layers; }
  const std::vector<std::size_t>& Begins() const { return this->Firsts; }

private:
  glm::ivec2 ViewportSize{ 0 };
  std::vector<Layer> Layers;
  std::vector<std::size_t> Firsts;
};

}

#endif
