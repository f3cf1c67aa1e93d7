// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/LayerLimit.h"

#include "Scene/Parallel.h"
#include "Scene/RayBatch.h"
#include "Scene/Tiles.h"
#include "Shade/LimitedLayers.h"

namespace TemporalCoherence
{

LayerLimit::LayerLimit(const LayerOptions& options, Frame& frame)
  : OfPixel(options.OfPixel)
  , MostOfFrame(static_cast<std::int64_t>(options.Bytes / sizeof(LayerHit)))
  , IsNeeded(!frame.Layers.empty() &&
      static_cast<std::int64_t>(options.OfPixel) * frame.Size.x * frame.Size.y > this->MostOfFrame)
{
  frame.LayersOfPixel = options.OfPixel;
  this->IsCounted.resize(this->IsNeeded ? frame.Layers.size() : 0);
}

void LayerLimit::Take(std::int64_t tile, Frame& frame)
{
  const auto place = static_cast<std::size_t>(tile);
  if (!this->IsNeeded || frame.Layers[place].empty())
  {
    return;
  }
  this->Total += static_cast<std::int64_t>(frame.Layers[place].size());
  this->Behind += static_cast<std::int64_t>(frame.Behind[place].Hits.size());
  if (this->AreTooMany())
  {
    this->Count(tile, frame);
    this->Merge(tile, this->OfPixel >> this->CurrentLevel(), frame);
  }
}

/// Count the layers that a tile would keep at each level. Most frames need no counts.
void LayerLimit::Count(std::int64_t tile, const Frame& frame)
{
  const auto place = static_cast<std::size_t>(tile);
  this->IsCounted[place] = 1;
  const PlaceFinder places(PixelsOfTile(frame.Size, tile), frame.Size.x);
  RayBatch::Array<std::size_t> ofPixel{};
  for (const LayerHit& hit : frame.Layers[place])
  {
    ++ofPixel[places.Find(hit.Pixel)];
  }
  std::size_t limit = this->OfPixel;
  for (std::atomic<std::int64_t>& kept : this->Kept)
  {
    std::int64_t sum = 0;
    for (std::size_t& count : ofPixel)
    {
      while (count > limit)
      {
        count = (count + 1) / 2;
      }
      sum += static_cast<std::int64_t>(count);
    }
    kept += sum;
    limit = limit > 1 ? limit / 2 : 1;
  }
}

/// The level at which the layers of all counted tiles fit.
std::size_t LayerLimit::CurrentLevel() const
{
  std::size_t level = 0;
  while (this->OfPixel >> level > 1 && this->Kept[level] > this->MostOfFrame)
  {
    ++level;
  }
  return level;
}

void LayerLimit::Merge(std::int64_t tile, std::size_t limit, Frame& frame)
{
  const auto place = static_cast<std::size_t>(tile);
  if (limit < this->OfPixel && !frame.Layers[place].empty())
  {
    this->Merged += static_cast<std::int64_t>(LimitLayers(limit, PixelsOfTile(frame.Size, tile),
      frame.Size.x, frame.Layers[place], frame.Behind[place]));
    GiveBackMemory(frame.Layers[place]);
  }
}

void LayerLimit::Finish(Frame& frame, FrameStatistics& statistics)
{
  const std::int64_t tiles = NumberOfTiles(frame.Size);
  if (this->AreTooMany())
  {
    ParallelFor(tiles, TileGrain,
      [&](std::int64_t tile)
      {
        if (!this->IsCounted[static_cast<std::size_t>(tile)])
        {
          this->Count(tile, frame);
        }
      });
    frame.LayersOfPixel = this->OfPixel >> this->CurrentLevel();
    ParallelFor(
      tiles, TileGrain, [&](std::int64_t tile) { this->Merge(tile, frame.LayersOfPixel, frame); });
    statistics.MergedLayers += this->Merged;
  }
  if (this->Total + this->Behind > this->MostOfFrame)
  {
    this->ForgetBehindIfTooMany(frame);
  }
}

/// Forget layers that no light reaches where they do not fit beside the visible layers.
void LayerLimit::ForgetBehindIfTooMany(Frame& frame) const
{
  std::size_t sum = 0;
  for (std::size_t tile = 0; tile < frame.Layers.size(); ++tile)
  {
    sum += frame.Layers[tile].size() + frame.Behind[tile].Hits.size();
  }
  for (std::size_t tile = 0;
       tile < frame.Behind.size() && static_cast<std::int64_t>(sum) > this->MostOfFrame; ++tile)
  {
    LayersBehind& behind = frame.Behind[tile];
    const PixelRect part = PixelsOfTile(frame.Size, static_cast<std::int64_t>(tile));
    const PlaceFinder places(part, frame.Size.x);
    for (const LayerHit& hit : behind.Hits)
    {
      behind.Ends &= ~(std::uint64_t(1) << places.Find(hit.Pixel));
    }
    behind.Hits = {};
  }
}

bool KeepsAllLayers(std::int64_t tile, const Frame& frame, const LayerOptions& options)
{
  return frame.LayersOfPixel >= options.OfPixel || frame.Behind.empty() ||
    frame.Behind[static_cast<std::size_t>(tile)].Merged == 0;
}

}
