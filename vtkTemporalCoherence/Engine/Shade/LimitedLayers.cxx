// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/LimitedLayers.h"

#include <algorithm>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

/// Marks layers that will be removed.
constexpr std::int32_t NoPixel = -1;

std::uint64_t BitOf(std::size_t place)
{
  return std::uint64_t(1) << place;
}

/// Remove the layers without a pixel.
void RemoveMarked(std::vector<LayerHit>& layers)
{
  layers.erase(std::remove_if(layers.begin(), layers.end(),
                 [](const LayerHit& hit) { return hit.Pixel == NoPixel; }),
    layers.end());
}

/// Remove the hits of merged pixels, behind which nothing is known.
void RemoveHitsOfMerged(const PixelRect& part, int width, LayersBehind& behind)
{
  if (behind.Merged != 0)
  {
    const PlaceFinder places(part, width);
    const auto isMerged = [&](const LayerHit& hit)
    { return (behind.Merged & BitOf(places.Find(hit.Pixel))) != 0; };
    behind.Hits.erase(
      std::remove_if(behind.Hits.begin(), behind.Hits.end(), isMerged), behind.Hits.end());
  }
}

}

/// \param number of the layer
void LimitedLayers::KeepOneMore(std::size_t place, std::uint32_t number, const LayerHit& hit)
{
  if (number == this->Limit << this->Shift[place])
  {
    this->MergePairs(place);
  }
  const std::uint32_t shift = this->Shift[place];
  LayerHit& kept = this->Layers[this->Positions[number >> shift][place]];
  if ((number & ((1u << shift) - 1)) == 0)
  {
    kept = hit;
  }
  else
  {
    kept.Color = hit.Color;
  }
}

void LimitedLayers::MergePairs(std::size_t place)
{
  for (std::size_t i = 0; i < this->Limit / 2; ++i)
  {
    LayerHit& kept = this->Layers[this->Positions[i][place]];
    kept = this->Layers[this->Positions[2 * i][place]];
    kept.Color = this->Layers[this->Positions[2 * i + 1][place]].Color;
  }
  ++this->Shift[place];
}

void LimitedLayers::Finish()
{
  this->Taken = std::accumulate(this->Count.begin(), this->Count.end(), std::int64_t(0));
  if (static_cast<std::size_t>(this->Taken) == this->Layers.size())
  {
    return;
  }
  for (std::size_t place = 0; place < this->Count.size(); ++place)
  {
    const std::uint32_t shift = this->Shift[place];
    if (shift > 0)
    {
      this->HasMerged |= BitOf(place);
      const std::uint32_t kept = ((this->Count[place] - 1) >> shift) + 1;
      for (std::uint32_t i = kept; i < this->Limit; ++i)
      {
        this->Layers[this->Positions[i][place]].Pixel = NoPixel;
      }
    }
  }
  RemoveMarked(this->Layers);
}

std::size_t LimitLayers(std::size_t limit, const PixelRect& part, int width,
  std::vector<LayerHit>& layers, LayersBehind& behind)
{
  RayBatch::Array<std::size_t> count{};
  LayerPositions positions;
  const PlaceFinder places(part, width);
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const std::size_t place = places.Find(layers[i].Pixel);
    positions[count[place]++][place] = static_cast<std::uint16_t>(i);
  }
  const std::size_t before = layers.size();
  for (std::size_t place = 0; place < count.size(); ++place)
  {
    std::size_t kept = count[place];
    for (; kept > limit; kept = (kept + 1) / 2)
    {
      for (std::size_t i = 0; i < (kept + 1) / 2; ++i)
      {
        const std::size_t last = std::min(2 * i + 1, kept - 1);
        LayerHit& hit = layers[positions[i][place]];
        const auto color = layers[positions[last][place]].Color;
        hit = layers[positions[2 * i][place]];
        hit.Color = color;
      }
    }
    behind.Merged |= static_cast<std::uint64_t>(kept < count[place]) << place;
    for (std::size_t i = kept; i < count[place]; ++i)
    {
      layers[positions[i][place]].Pixel = NoPixel;
    }
  }
  RemoveMarked(layers);
  behind.Ends &= ~behind.Merged;
  RemoveHitsOfMerged(part, width, behind);
  return before - layers.size();
}

void GiveBackMemory(std::vector<LayerHit>& layers)
{
  // A growing list takes up to twice the memory that it needs. Small lists may stay as they are.
  constexpr std::size_t small = 64;
  if (layers.capacity() > 2 * layers.size() + small)
  {
    layers.shrink_to_fit();
  }
}

}
