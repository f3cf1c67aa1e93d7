// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LimitedLayers_h
#define TemporalCoherence_LimitedLayers_h

#include "Scene/Frame.h"
#include "Scene/RayBatch.h"
#include "Scene/Tiles.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Positions in a list of layers, by number of the layer and place of its pixel in the tile.
using LayerPositions = std::array<RayBatch::Array<std::uint16_t>, MostKeptLayers>;

/// Takes the layers of a tile while they are composited, and keeps a limited number for each pixel.
/// Above the limit, merges every second layer into the layer in front: from then on, each kept
/// layer stands for twice as many. So the kept layers depend only on the pixel's layers, and are
/// spread evenly over them.
class LimitedLayers
{
public:
  /// \param limit  most layers of a pixel: a power of two, at most MostKeptLayers
  /// \param layers result: the kept layers
  LimitedLayers(std::size_t limit, std::vector<LayerHit>& layers)
    : Limit(static_cast<std::uint32_t>(limit))
    , Layers(layers)
  {
    layers.clear();
  }

  /// Take the next layer of a pixel.
  /// \param place of the pixel in the tile
  /// \throws std::bad_alloc
  void Keep(std::size_t place, const LayerHit& hit)
  {
    const std::uint32_t number = this->Count[place]++;
    if (number >= this->Limit)
    {
      this->KeepOneMore(place, number, hit);
      return;
    }
    this->Positions[number][place] = static_cast<std::uint16_t>(this->Layers.size());
    this->Layers.push_back(hit);
  }

  /// Keep a layer that no light reaches, if its pixel has room for it.
  /// \param behind gets it
  /// \throws std::bad_alloc
  void KeepBehind(std::size_t place, const LayerHit& hit, std::vector<LayerHit>& behind)
  {
    if (this->Count[place] + this->CountBehind[place] < this->Limit)
    {
      ++this->CountBehind[place];
      behind.push_back(hit);
    }
    else
    {
      this->HasDropped |= std::uint64_t(1) << place;
    }
  }

  /// Remove surplus layers of merged pixels. Call this once, after the last layer.
  void Finish();

  /// One bit for each pixel with merged layers, by its place.
  /// \pre Finish
  std::uint64_t Merged() const { return this->HasMerged; }

  /// One bit for each pixel with merged or dropped layers, by its place.
  /// \pre Finish
  std::uint64_t Incomplete() const { return this->HasMerged | this->HasDropped; }

  /// The number of layers that were taken.
  /// \pre Finish
  std::int64_t Total() const { return this->Taken; }

private:
  void KeepOneMore(std::size_t place, std::uint32_t number, const LayerHit& hit);
  void MergePairs(std::size_t place);

  std::uint32_t Limit;
  std::vector<LayerHit>& Layers;
  RayBatch::Array<std::uint32_t> Count{};       ///< layers that were taken, by place
  RayBatch::Array<std::uint32_t> CountBehind{}; ///< kept layers behind them, by place
  RayBatch::Array<std::uint8_t> Shift{};        ///< each kept layer stands for 1 << Shift layers
  LayerPositions Positions;                     ///< of the first Limit layers of each pixel
  std::uint64_t HasMerged = 0, HasDropped = 0;
  std::int64_t Taken = 0;
};

/// Merge layers of a tile until no pixel has more than a lower limit. LimitedLayers with that limit
/// would keep the same layers.
/// \param limit  a power of two
/// \param part   the pixels of the tile
/// \param width  of the picture
/// \param behind gets the merged pixels, and loses its hits of these pixels
/// \return number of merged layers
std::size_t LimitLayers(std::size_t limit, const PixelRect& part, int width,
  std::vector<LayerHit>& layers, LayersBehind& behind);

/// Give back memory if most of it is not used.
void GiveBackMemory(std::vector<LayerHit>& layers);

}

#endif
