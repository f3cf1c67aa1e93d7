// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RecoloredLayers_h
#define TemporalCoherence_RecoloredLayers_h

#include "Layers/LimitedLayers.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Finds anew the colours of pixels with merged layers, without changing what is kept.
class RecoloredLayers
{
public:
  /// \param part   the pixels of a tile
  /// \param width  of the picture
  /// \param merged pixels with merged layers
  /// \param layers of the tile
  RecoloredLayers(
    const PixelRect& part, int width, std::uint64_t merged, std::vector<LayerHit>& layers);

  /// The first layer that is kept of a pixel. \pre it has merged layers
  const LayerHit& FirstOf(std::size_t place) const
  {
    return this->Layers[this->Positions[0][place]];
  }

  /// Take the next layer of a pixel with merged layers; the one after the first one to begin with.
  void Keep(std::size_t place, const LayerHit& hit);

  std::int64_t Total() const { return this->Taken; }             ///< layers that were taken
  std::int64_t NumberMerged() const { return this->MergedHere; } ///< of these, those not kept

private:
  std::vector<LayerHit>& Layers;
  std::int64_t Taken = 0, MergedHere = 0;
  RayBatch::Array<std::uint8_t> Count{}; ///< layers that are kept, by place
  RayBatch::Array<std::uint8_t> Now{};   ///< the one of these that takes colours
  LayerPositions Positions;
};

}

#endif
