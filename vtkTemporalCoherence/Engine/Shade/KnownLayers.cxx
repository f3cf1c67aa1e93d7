// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/KnownLayers.h"

#include "Scene/LayerBatch.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Call visit(pixel, place) for the pixels of a tile.
template <typename Visit>
void ForEachPixel(const PixelRect& part, int width, const Visit& visit)
{
  std::size_t place = 0;
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    for (int x = part.First.x; x < part.First.x + part.Size.x; ++x, ++place)
    {
      visit(y * width + x, place);
    }
  }
}

}

void OrderByRounds(const PixelRect& part, int width, std::vector<LayerHit>& layers)
{
  // Pixel by pixel first: `next` is where a pixel's next layer goes.
  std::array<std::size_t, RayBatch::Capacity + 1> next{};
  for (const LayerHit& hit : layers)
  {
    ++next[PlaceInTile(part, width, hit.Pixel) + 1];
  }
  std::uint64_t left = 0;
  for (std::size_t place = 0; place < RayBatch::Capacity; ++place)
  {
    left |= static_cast<std::uint64_t>(next[place + 1] > 0) << place;
    next[place + 1] += next[place];
  }
  std::array<std::size_t, RayBatch::Capacity + 1> first = next;
  std::vector<LayerHit> byPixel(layers.size());
  for (const LayerHit& hit : layers)
  {
    byPixel[next[PlaceInTile(part, width, hit.Pixel)]++] = hit;
  }
  // `next` is the end of each pixel's layers now.
  layers.clear();
  while (left != 0)
  {
    ForEachRay(left,
      [&](std::size_t place)
      {
        layers.push_back(byPixel[first[place]++]);
        left &= ~(static_cast<std::uint64_t>(first[place] == next[place]) << place);
      });
  }
}

KnownLayers::KnownLayers(std::int64_t tile, const PixelRect& part, const Frame& frame)
{
  const auto place = static_cast<std::size_t>(tile);
  if (frame.Layers.empty())
  {
    this->TakeHits(part, frame);
  }
  else
  {
    this->List = &frame.Layers[place];
  }
  if (frame.Behind.empty())
  {
    return;
  }
  this->Ended |= frame.Behind[place].Ends;
  const std::vector<LayerHit>& behind = frame.Behind[place].Hits;
  if (!behind.empty())
  {
    std::vector<LayerHit> all;
    all.reserve(this->List->size() + behind.size());
    all.insert(all.end(), this->List->begin(), this->List->end());
    all.insert(all.end(), behind.begin(), behind.end());
    OrderByRounds(part, frame.Size.x, all);
    this->Collected.swap(all);
    this->List = &this->Collected;
  }
}

/// Take the hits of opaque surfaces.
void KnownLayers::TakeHits(const PixelRect& part, const Frame& frame)
{
  ForEachPixel(part, frame.Size.x,
    [&](std::int32_t pixel, std::size_t place)
    {
      const auto at = static_cast<std::size_t>(pixel);
      const std::int16_t surface = frame.Isovalues[at];
      if (surface != Frame::NoSurface)
      {
        this->Collected.push_back({ frame.Depth[at], pixel, surface, frame.Kinds[at] });
      }
      this->Ended |= static_cast<std::uint64_t>(surface == Frame::NoSurface) << place;
    });
}

void StoreFirstLayers(
  const KnownLayers& known, std::int64_t tile, const PixelRect& part, Frame& frame)
{
  ForEachPixel(part, frame.Size.x,
    [&](std::int32_t pixel, std::size_t)
    {
      frame.Depth[static_cast<std::size_t>(pixel)] = std::numeric_limits<double>::infinity();
      frame.Isovalues[static_cast<std::size_t>(pixel)] = Frame::NoSurface;
    });
  LayersBehind& behind = frame.Behind[static_cast<std::size_t>(tile)];
  behind.Hits.clear();
  behind.Ends = known.Ends();
  for (const LayerHit& hit : known.All())
  {
    const auto pixel = static_cast<std::size_t>(hit.Pixel);
    if (frame.Isovalues[pixel] == Frame::NoSurface)
    {
      frame.Depth[pixel] = hit.Depth;
      frame.Isovalues[pixel] = hit.Isovalue;
    }
    else
    {
      behind.Hits.push_back(hit);
    }
  }
}

}
