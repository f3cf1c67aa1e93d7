// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnownLayers_h
#define TemporalCoherence_KnownLayers_h

#include "Scene/Frame.h"
#include "Scene/Tiles.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Bring the layers of a tile into the order of Frame::Layers: round by round from front to back,
/// and by pixel within a round.
/// \param width  of the picture
/// \param layers those of each pixel from front to back
/// \throws std::bad_alloc
void OrderByRounds(const PixelRect& part, int width, std::vector<LayerHit>& layers);

/// What a finished picture knows about the layers of one of its tiles, whatever their opacities.
class KnownLayers
{
public:
  /// \param part  the pixels of tile number `tile`
  /// \param frame must outlive this
  /// \throws std::bad_alloc
  KnownLayers(std::int64_t tile, const PixelRect& part, const Frame& frame);
  KnownLayers(const KnownLayers&) = delete;
  KnownLayers& operator=(const KnownLayers&) = delete;

  /// Those that are composited and those behind, in the order of Frame::Layers. If surfaces are
  /// opaque, the first ones are the hits.
  const std::vector<LayerHit>& All() const { return *this->List; }

  /// One bit for each pixel of the tile, row by row: it has no layers but these.
  std::uint64_t Ends() const { return this->Ended; }

private:
  void TakeHits(const PixelRect& part, const Frame& frame);

  std::vector<LayerHit> Collected;
  const std::vector<LayerHit>* List = &this->Collected;
  std::uint64_t Ended = 0;
};

/// Make the first layers of a tile the hits of a picture with opaque surfaces. The others are
/// behind them. \throws std::bad_alloc
void StoreFirstLayers(
  const KnownLayers& known, std::int64_t tile, const PixelRect& part, Frame& frame);

}

#endif
