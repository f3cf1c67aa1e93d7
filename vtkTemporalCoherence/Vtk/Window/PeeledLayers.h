// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeeledLayers_h
#define TemporalCoherence_PeeledLayers_h

#include "Scene/Frame.h"
#include "Scene/View.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The layers at each pixel of a picture, or of a viewport with several pictures: from front to
/// back up to the first opaque one.
class PeeledLayers
{
public:
  /// A colour as textures of 16 bits hold it: premultiplied RGBA, 65535 is 1. Several layers lie
  /// over one another in a pixel: their errors add up, and errors of bytes would be visible.
  using FineColor = std::array<std::uint16_t, 4>;

  /// A layer at a pixel.
  struct Layer
  {
    float Depth;     ///< of the depth buffer
    FineColor Color; ///< of this layer alone
  };

  /// Make the layers of one picture, ray by ray.
  /// \param isBlended the picture shows a blended volume: one layer at its first visible place
  /// \throws std::bad_alloc
  static PeeledLayers Of(const Frame& frame, const View& view, bool isBlended);

  /// Remove all layers.
  /// \param size pixels of the viewport
  void Clear(const glm::ivec2& size);

  /// Merge a picture with the present ones. A pixel takes the layers of the ray at its centre.
  /// \throws std::bad_alloc
  void Add(const PeeledLayers& picture);

  const glm::ivec2& Size() const { return this->Pixels; }

  /// The layers of all pixels, row by row from below. Begins() holds the position of each pixel's
  /// first layer, and the end of all.
  const std::vector<Layer>& All() const { return this->Layers; }
  const std::vector<std::size_t>& Begins() const { return this->Firsts; }

private:
  glm::ivec2 Pixels{ 0 };
  std::vector<Layer> Layers;
  std::vector<std::size_t> Firsts;
};

}

#endif
