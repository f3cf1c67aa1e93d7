// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RecoloredLayers_h
#define TemporalCoherence_RecoloredLayers_h

#include "Shade/LimitedLayers.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Finds new colours for pixels with merged layers, which keep their layers.
class RecoloredLayers
{
public:
  /// \param part   the pixels of a tile
  /// \param width  of the picture
  /// \param merged pixels with merged layers
  /// \param layers of the tile
  RecoloredLayers(
    const PixelRect& part, int width, std::uint64_t merged, std::vector<LayerHit>& layers);

  /// The first kept layer of a pixel.
  /// \pre it has merged layers
  const LayerHit& FirstOf(std::size_t place) const
  {
    return this->Layers[this->Positions[0][place]];
  }

  /// Take the next layer of a pixel with merged layers, beginning with the second layer.
  void Keep(std::size_t place, const LayerHit& hit);

  std::int64_t Total() const { return this->Taken; }             ///< layers that were taken
  std::int64_t NumberMerged() const { return this->MergedHere; } ///< taken layers that are not kept

private:
  std::vector<LayerHit>& Layers;
  std::int64_t Taken = 0, MergedHere = 0;
  RayBatch::Array<std::uint8_t> Count{}; ///< kept layers, by place
  RayBatch::Array<std::uint8_t> Now{};   ///< number of the kept layer that takes colours
  LayerPositions Positions;
};

}

#endif
