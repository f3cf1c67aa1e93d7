// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnownLayers_h
#define TemporalCoherence_KnownLayers_h

#include "Scene/Frame.h"
#include "Scene/Tiles.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Bring the layers of a tile into the order of Frame::Layers: round by round from front to back,
/// and by pixel within a round.
/// \param width  of the picture
/// \param layers from front to back within each pixel
/// \throws std::bad_alloc
void OrderByRounds(const PixelRect& part, int width, std::vector<LayerHit>& layers);

/// The layers of one tile that a finished picture knows, whatever their opacities.
class KnownLayers
{
public:
  /// \param part  the pixels of tile number `tile`
  /// \param frame must outlive this
  /// \throws std::bad_alloc
  KnownLayers(std::int64_t tile, const PixelRect& part, const Frame& frame);

  KnownLayers(const KnownLayers&) = delete;
  KnownLayers& operator=(const KnownLayers&) = delete;

  /// The composited layers, in the order of Frame::Layers; only the first layer of pixels with
  /// merged layers. If surfaces are opaque: the hits.
  const std::vector<LayerHit>& Composited() const { return *this->Seen; }

  /// The layers behind the composited ones, from front to back within each pixel.
  const std::vector<LayerHit>& Behind() const { return *this->Hidden; }

  /// Call visit(hit) for all known layers, from front to back within each pixel.
  template <typename Visit>
  void ForEach(const Visit& visit) const
  {
    std::for_each(this->Seen->begin(), this->Seen->end(), visit);
    std::for_each(this->Hidden->begin(), this->Hidden->end(), visit);
  }

  /// One bit for each pixel of the tile, row by row: all of its layers are known.
  std::uint64_t Ends() const { return this->Ended; }

private:
  void TakeHits(const PixelRect& part, const Frame& frame);
  void TakeFirstOfMerged(
    const PixelRect& part, int width, std::uint64_t merged, const std::vector<LayerHit>& layers);

  std::vector<LayerHit> Hits; ///< of opaque surfaces, or of a tile with merged layers
  std::vector<LayerHit> None;
  const std::vector<LayerHit>* Seen = &this->Hits;
  const std::vector<LayerHit>* Hidden = &this->None;
  std::uint64_t Ended = 0;
};

/// Store a tile in which no ray meets anything.
/// \pre frame.Behind has the tile
void StoreClearTile(std::int64_t tile, const PixelRect& part, bool isParallel, Frame& frame);

/// Make the first layers of a tile the hits of a picture with opaque surfaces. The others are
/// behind them.
/// \throws std::bad_alloc
void StoreFirstLayers(
  const KnownLayers& known, std::int64_t tile, const PixelRect& part, Frame& frame);

}

#endif
