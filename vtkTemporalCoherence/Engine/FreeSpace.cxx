// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FreeSpace.h"

#include "Disparity.h"
#include "KernelsImage.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Neighbours of a smooth surface leave the plane through the pixel by at most this share of the
/// margin in depth; the margin is then this share of itself.
constexpr double SmoothBend = 0.25;
constexpr double SmoothMargin = 0.125;

constexpr std::int64_t TileGrain = 64;

/// Gather the disparities of a tile and of the pixels around it.
void GatherAround(
  const Frame& frame, const PixelRect& part, float outside, bool onlyEntered, GuardTile& tile)
{
  for (int y = 0; y < GuardTile::Width; ++y)
  {
    float* const out = &tile.Around[static_cast<std::size_t>(y * GuardTile::Width)];
    const int row = part.First.y + y - 1;
    const int begin = std::max(part.First.x - 1, 0);
    const int end = std::min(part.First.x + TileSize + 1, frame.Size.x);
    std::fill_n(out, GuardTile::Width, outside);
    if (row < 0 || row >= frame.Size.y)
    {
      continue;
    }
    const auto first = static_cast<std::size_t>(row * frame.Size.x + begin);
    float* const at = out + (begin - part.First.x + 1);
    std::copy_n(&frame.Disparities[first], end - begin, at);
    for (int x = 0; onlyEntered && x < end - begin; ++x)
    {
      at[x] = frame.Kinds[first + static_cast<std::size_t>(x)] == HitKind::Enters
        ? at[x]
        : std::numeric_limits<float>::infinity();
    }
  }
}

/// True if a tile and all around it are known to show nothing.
bool IsClearAround(const Frame& frame, std::int64_t tile)
{
  const glm::ivec2 tiles = TilesOf(frame.Size);
  const glm::ivec2 at(tile % tiles.x, tile / tiles.x);
  const glm::ivec2 first = glm::max(at - 1, glm::ivec2(0));
  const glm::ivec2 last = glm::min(at + 1, tiles - 1);
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      if (!frame.ClearTiles[static_cast<std::size_t>(y * tiles.x + x)])
      {
        return false;
      }
    }
  }
  return true;
}

}

void FreeSpace::Make(const Frame& frame, const View& view, const Options& options)
{
  if (this->IsMade && this->MadeWith == options)
  {
    return;
  }
  const auto tiles = static_cast<std::size_t>(NumberOfTiles(frame.Size));
  if (this->Disparities.size() != frame.Disparities.size() || this->Filled.size() != tiles)
  {
    this->Filled.assign(tiles, std::numeric_limits<float>::quiet_NaN());
    this->Disparities.resize(frame.Disparities.size());
  }
  const double miss = DisparityOfMiss(view.Parallel);
  GuardRule rule;
  rule.IsParallel = view.Parallel;
  rule.Margin = static_cast<float>(options.Margin);
  rule.SmoothMargin = static_cast<float>(SmoothMargin * options.Margin);
  rule.LargestBend = static_cast<float>(SmoothBend * options.Margin);
  rule.Farthest = static_cast<float>(std::isfinite(options.FarthestDepth)
      ? DisparityOf(options.FarthestDepth, view.Parallel)
      : miss);

  ParallelFor(NumberOfTiles(frame.Size), TileGrain,
    [&](std::int64_t number)
    {
      const PixelRect part = PixelsOfTile(frame.Size, number);
      const bool isClear = !options.OnlyEntered && IsClearAround(frame, number);
      float& filled = this->Filled[static_cast<std::size_t>(number)];
      if (isClear && filled == rule.Farthest)
      {
        return;
      }
      filled = isClear ? rule.Farthest : std::numeric_limits<float>::quiet_NaN();
      GuardTile tile;
      if (isClear)
      {
        tile.Guard.fill(rule.Farthest);
      }
      else
      {
        GatherAround(frame, part, static_cast<float>(miss), options.OnlyEntered, tile);
        MakeGuard(rule, tile);
      }
      for (int y = 0; y < part.Size.y; ++y)
      {
        std::copy_n(&tile.Guard[static_cast<std::size_t>(y * TileSize)], part.Size.x,
          &this->Disparities[static_cast<std::size_t>(
            (part.First.y + y) * frame.Size.x + part.First.x)]);
      }
    });
  this->IsMade = true;
  this->MadeWith = options;
}

}
