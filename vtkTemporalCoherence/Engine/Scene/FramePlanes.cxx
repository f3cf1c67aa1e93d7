// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FramePlanes.h"

#include "Scene/Disparity.h"

#include <algorithm>
#include <type_traits>

namespace TemporalCoherence
{
namespace
{

std::size_t PlaceOf(const Frame& frame, int x, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
}

}

void StoreMisses(std::int64_t tile, const PixelRect& part, bool isParallel, Frame& frame)
{
  std::uint8_t& isClear = frame.ClearTiles[static_cast<std::size_t>(tile)];
  if (isClear)
  {
    return;
  }
  const auto miss = static_cast<float>(DisparityOfMiss(isParallel));
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::size_t row = PlaceOf(frame, part.First.x, y);
    Frame::ForEachPlane(miss,
      [&](auto plane, const auto& value)
      {
        if (!(frame.*plane).empty())
        {
          std::fill_n(&(frame.*plane)[row], part.Size.x, value);
        }
      });
  }
  isClear = 1;
}

TraceCounts CopyTile(
  std::int64_t tile, const PixelRect& part, const Frame& from, bool isParallel, Frame& frame)
{
  TraceCounts counts;
  const auto place = static_cast<std::size_t>(tile);
  if (!frame.Layers.empty())
  {
    frame.Layers[place] = from.Layers[place];
    frame.Behind[place] = from.Behind[place];
  }
  if (from.ClearTiles[place])
  {
    StoreMisses(tile, part, isParallel, frame);
    counts.DefiniteMisses = static_cast<std::int64_t>(part.Size.x) * part.Size.y;
    return counts;
  }
  frame.ClearTiles[place] = 0;
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::size_t row = PlaceOf(frame, part.First.x, y);
    const auto count = static_cast<std::size_t>(part.Size.x);
    Frame::ForEachPlane(0.0f,
      [&](auto plane, const auto&)
      {
        if (!(frame.*plane).empty())
        {
          std::copy_n(&(from.*plane)[row], count, &(frame.*plane)[row]);
        }
      });
    for (std::size_t pixel = row; pixel < row + count; ++pixel)
    {
      const bool isHit = from.Isovalues[pixel] != Frame::NoSurface;
      frame.Answers[pixel] = isHit ? Answer::DefiniteHit : Answer::DefiniteMiss;
      counts.DefiniteHits += isHit;
      counts.DefiniteMisses += !isHit;
    }
  }
  return counts;
}

void CopyRays(const PixelRect& part, const Frame& from, Frame& frame)
{
  const auto count = static_cast<std::size_t>(part.Size.x);
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::size_t row = PlaceOf(frame, part.First.x, y);
    const auto copy = [&](auto plane)
    {
      if (!(frame.*plane).empty())
      {
        std::copy_n(&(from.*plane)[row], count, &(frame.*plane)[row]);
      }
    };
    copy(&Frame::Kinds);
    copy(&Frame::Answers);
    copy(&Frame::Disparities);
    copy(&Frame::Cells);
  }
}

float DisparityAt(const RayBatch& rays, std::size_t ray, double t, bool isParallel)
{
  const double perDepth = rays.PerDepth[ray];
  return static_cast<float>(
    isParallel ? std::max(-t / perDepth, DisparityOfMiss(true)) : perDepth / t);
}

namespace
{

/// Write the optional planes.
void StoreExtras(
  const RayBatch& rays, const HitBatch& hits, std::size_t ray, bool isParallel, Frame& frame)
{
  const auto pixel = static_cast<std::size_t>(rays.Pixel[ray]);
  if (!frame.Disparities.empty())
  {
    frame.Disparities[pixel] = DisparityAt(rays, ray, hits.Depth[ray], isParallel);
  }
  if (!frame.Cells.empty())
  {
    frame.Cells[pixel] = hits.Cell[ray];
  }
}

}

void StoreHit(const RayBatch& rays, const HitBatch& hits, std::size_t ray, Answer answer,
  bool isParallel, Frame& frame)
{
  const auto pixel = static_cast<std::size_t>(rays.Pixel[ray]);
  frame.Depth[pixel] = hits.Depth[ray];
  frame.Isovalues[pixel] = hits.Surface[ray];
  frame.Kinds[pixel] = hits.Kind[ray];
  frame.Answers[pixel] = answer;
  StoreExtras(rays, hits, ray, isParallel, frame);
}

void StoreHits(const RayBatch& rays, const HitBatch& hits, const RayBatch::Array<Answer>& answers,
  bool isParallel, Frame& frame)
{
  const auto count = static_cast<std::size_t>(rays.Count);
  const auto copy = [&](std::size_t first, auto length)
  {
    const auto pixel = static_cast<std::size_t>(rays.Pixel[first]);
    std::copy_n(&hits.Depth[first], length, &frame.Depth[pixel]);
    std::copy_n(&hits.Surface[first], length, &frame.Isovalues[pixel]);
    std::copy_n(&hits.Kind[first], length, &frame.Kinds[pixel]);
    std::copy_n(&answers[first], length, &frame.Answers[pixel]);
  };
  if (rays.Count == RayBatch::Capacity)
  {
    // A whole tile: rows of a length that the compiler knows.
    for (std::size_t row = 0; row < count; row += TileSize)
    {
      copy(row, std::integral_constant<int, TileSize>());
    }
  }
  else
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      copy(i, std::integral_constant<int, 1>());
    }
  }
  const bool hasExtras = !frame.Disparities.empty() || !frame.Cells.empty();
  for (std::size_t i = 0; i < count && hasExtras; ++i)
  {
    StoreExtras(rays, hits, i, isParallel, frame);
  }
}

}
