// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/KnownLayers.h"

#include "Scene/FramePlanes.h"
#include "Scene/LayerBatch.h"
#include "Shade/LimitedLayers.h"

#include <algorithm>
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
  struct Round
  {
    std::uint64_t Pixels = 0; ///< pixels with a layer in this round, by their places in the tile
    std::size_t First = 0;    ///< where the layers of this round begin
  };
  const PlaceFinder places(part, width);
  const std::vector<LayerHit> before = layers;
  std::vector<Round> rounds;
  RayBatch::Array<std::uint32_t> count{};
  for (const LayerHit& hit : before)
  {
    const std::size_t place = places.Find(hit.Pixel);
    const std::size_t round = count[place]++;
    rounds.resize(std::max(rounds.size(), round + 1));
    rounds[round].Pixels |= std::uint64_t(1) << place;
  }
  for (std::size_t round = 1; round < rounds.size(); ++round)
  {
    const Round& last = rounds[round - 1];
    rounds[round].First = last.First + hwy::PopCount(last.Pixels);
  }
  count = {};
  for (const LayerHit& hit : before)
  {
    const std::size_t place = places.Find(hit.Pixel);
    const Round& round = rounds[count[place]++];
    const std::uint64_t inFront = round.Pixels & ((std::uint64_t(1) << place) - 1);
    layers[round.First + hwy::PopCount(inFront)] = hit;
  }
}

KnownLayers::KnownLayers(std::int64_t tile, const PixelRect& part, const Frame& frame)
{
  const auto place = static_cast<std::size_t>(tile);
  if (!frame.Behind.empty())
  {
    this->Hidden = &frame.Behind[place].Hits;
    this->Ended = frame.Behind[place].Ends;
  }
  if (frame.Layers.empty())
  {
    this->TakeHits(part, frame);
  }
  else if (!frame.Behind.empty() && frame.Behind[place].Merged != 0)
  {
    this->TakeFirstOfMerged(part, frame.Size.x, frame.Behind[place].Merged, frame.Layers[place]);
  }
  else
  {
    this->Seen = &frame.Layers[place];
  }
}

/// Take all layers, but only the first layer of pixels with merged layers.
void KnownLayers::TakeFirstOfMerged(
  const PixelRect& part, int width, std::uint64_t merged, const std::vector<LayerHit>& layers)
{
  const PlaceFinder places(part, width);
  std::uint64_t begun = 0;
  for (const LayerHit& hit : layers)
  {
    const std::uint64_t bit = std::uint64_t(1) << places.Find(hit.Pixel) & merged;
    if ((begun & bit) == 0)
    {
      begun |= bit;
      this->Hits.push_back(hit);
    }
  }
}

/// Take the hits of opaque surfaces.
void KnownLayers::TakeHits(const PixelRect& part, const Frame& frame)
{
  ForEachPixel(part, frame.Size.x,
    [&](std::int32_t pixel, std::size_t place)
    {
      const auto at = static_cast<std::size_t>(pixel);
      const SurfaceIndex surface = frame.Isovalues[at];
      if (surface != Frame::NoSurface)
      {
        const CellNumber cell = frame.Cells.empty() ? NoCell : frame.Cells[at];
        this->Hits.push_back({ frame.Depth[at], pixel, surface, frame.Kinds[at], {}, cell });
      }
      this->Ended |= static_cast<std::uint64_t>(surface == Frame::NoSurface) << place;
    });
}

void StoreClearTile(std::int64_t tile, const PixelRect& part, bool isParallel, Frame& frame)
{
  const auto place = static_cast<std::size_t>(tile);
  if (!frame.Layers.empty())
  {
    frame.Layers[place].clear();
    GiveBackMemory(frame.Layers[place]);
  }
  frame.Behind[place] = {};
  StoreMisses(tile, part, isParallel, frame);
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
  behind.Merged = 0;
  known.ForEach(
    [&](const LayerHit& hit)
    {
      const auto pixel = static_cast<std::size_t>(hit.Pixel);
      if (frame.Isovalues[pixel] == Frame::NoSurface)
      {
        frame.Depth[pixel] = hit.Depth;
        frame.Isovalues[pixel] = hit.Isovalue;
        // The planes of the last frame hold its first visible layer.
        frame.Kinds[pixel] = hit.Kind;
        if (!frame.Cells.empty())
        {
          frame.Cells[pixel] = hit.Cell;
        }
      }
      else
      {
        behind.Hits.push_back(hit);
      }
    });
}

}
