// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCache/FreeSpace.h"

#include "ImageCache/KernelsImage.h"
#include "Scene/Disparity.h"
#include "Scene/Parallel.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

// A surface is smooth if, in voxels of depth, neighbours are at most LargestBend from the plane
// through the pixel, and the surface is at most LargestGap behind the first active cell. A smooth
// surface is taken to be SmoothMargin nearer than it is, any other one EdgeMargin. Measured by
// `Benchmark --scenarios image-cache`: smaller margins gain little and double the errors
// (Documentation/Tried.md, "The image cache").
constexpr double LargestBend = 0.25;
constexpr double LargestGap = 2.0;
constexpr double SmoothMargin = 0.125;
constexpr double EdgeMargin = 1.5;

using Around = std::array<float, GuardTile::Width * GuardTile::Width>;

/// The pixels of a frame in and around a tile.
PixelRect Surroundings(const Frame& frame, const PixelRect& part)
{
  const glm::ivec2 first = glm::max(part.First - 1, glm::ivec2(0));
  return { first, glm::min(part.First + TileSize + 1, frame.Size) - first };
}

/// Gather a plane of the frame around a tile, with one more pixel on all sides.
void GatherAround(const Frame& frame, const Plane<float>& plane, const PixelRect& part,
  float outside, Around& around)
{
  around.fill(outside);
  const PixelRect rect = Surroundings(frame, part);
  const glm::ivec2 at = rect.First - part.First + 1;
  for (int y = 0; y < rect.Size.y; ++y)
  {
    std::copy_n(&plane[static_cast<std::size_t>((rect.First.y + y) * frame.Size.x + rect.First.x)],
      rect.Size.x, &around[static_cast<std::size_t>((at.y + y) * GuardTile::Width + at.x)]);
  }
}

/// Call visit(position around the tile, pixel of the frame) for each pixel within the frame.
template <typename Visit>
void VisitAround(const Frame& frame, const PixelRect& part, const Visit& visit)
{
  const PixelRect rect = Surroundings(frame, part);
  for (int y = rect.First.y; y < rect.First.y + rect.Size.y; ++y)
  {
    for (int x = rect.First.x; x < rect.First.x + rect.Size.x; ++x)
    {
      const glm::ivec2 at = glm::ivec2(x, y) - part.First + 1;
      visit(static_cast<std::size_t>(at.y * GuardTile::Width + at.x),
        static_cast<std::size_t>(y * frame.Size.x + x));
    }
  }
}

/// Find the disparities from which surfaces alone tell what is free.
void GatherFine(const Frame& frame, const PixelRect& part, float fine, Around& fines)
{
  fines.fill(fine);
  VisitAround(frame, part,
    [&](std::size_t at, std::size_t pixel)
    {
      if (frame.Kinds[pixel] == HitKind::Exit || frame.Kinds[pixel] == HitKind::Within)
      {
        fines[at] = std::numeric_limits<float>::infinity();
      }
    });
}

/// True if a tile and all of its neighbours are clear.
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

/// Finite also for a point at the camera.
float FiniteDisparityOf(double depth, bool isParallel)
{
  const double away = isParallel ? depth : std::max(depth, 1e-30);
  return static_cast<float>(std::clamp(DisparityOf(away, isParallel), -1e30, 1e30));
}

GuardRule RuleFor(const View& view, const FreeSpace::Options& options)
{
  GuardRule rule;
  rule.IsParallel = view.Parallel;
  rule.EdgeMargin = static_cast<float>(EdgeMargin * options.Voxel);
  rule.SmoothMargin = static_cast<float>(SmoothMargin * options.Bend);
  rule.LargestBend = static_cast<float>(LargestBend * options.Bend);
  rule.LargestGap = static_cast<float>(LargestGap * options.Bend);
  rule.Spacing = static_cast<float>(options.Spacing);
  rule.Farthest = FiniteDisparityOf(options.FarthestDepth, view.Parallel);
  return rule;
}

}

void FreeSpace::Make(const Frame& frame, const View& view, const Options& options)
{
  if (this->IsMade && this->MadeWith == options)
  {
    return;
  }
  if (this->Size != frame.Size)
  {
    this->Size = glm::ivec2(0);
    this->Disparities.resize(frame.Disparities.size());
    this->Filled.assign(
      static_cast<std::size_t>(NumberOfTiles(frame.Size)), std::numeric_limits<float>::quiet_NaN());
    this->Size = frame.Size;
  }
  const auto miss = static_cast<float>(DisparityOfMiss(view.Parallel));
  const GuardRule rule = RuleFor(view, options);
  const float fine = FiniteDisparityOf(options.FineDepth, view.Parallel);
  ParallelFor(NumberOfTiles(frame.Size), 8 * TileGrain,
    [&](std::int64_t number)
    {
      const PixelRect part = PixelsOfTile(frame.Size, number);
      const bool isClear = IsClearAround(frame, number);
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
        GatherAround(frame, frame.Disparities, part, miss, tile.Surface);
        GatherAround(frame, frame.FirstEntries, part, miss, tile.FirstEntry);
        GatherFine(frame, part, fine, tile.Fine);
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
