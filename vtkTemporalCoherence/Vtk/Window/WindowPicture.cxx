// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/WindowPicture.h"

#include "Scene/Parallel.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace TemporalCoherence
{
namespace
{

/// Rows of tiles that a thread takes at a time.
constexpr std::int64_t RowGrain = 2;

std::size_t PlaceOf(const Frame& frame, int x, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
}

bool HasHits(const Frame& frame, std::int64_t tile)
{
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return false;
  }
  const PixelRect part = PixelsOfTile(frame.Size, tile);
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::int16_t* const row = &frame.Isovalues[PlaceOf(frame, part.First.x, y)];
    if (std::any_of(
          row, row + part.Size.x, [](std::int16_t surface) { return surface != Frame::NoSurface; }))
    {
      return true;
    }
  }
  return false;
}

/// The smallest rectangle of tiles with all hits of a frame.
PixelRect FindHits(const Frame& frame)
{
  const glm::ivec2 tiles = TilesOf(frame.Size);
  glm::ivec2 first = tiles, last(-1);
  std::mutex guard;
  ParallelFor(tiles.y, RowGrain,
    [&](std::int64_t row)
    {
      int firstInRow = tiles.x, lastInRow = -1;
      for (int column = 0; column < tiles.x; ++column)
      {
        if (HasHits(frame, row * tiles.x + column))
        {
          firstInRow = std::min(firstInRow, column);
          lastInRow = column;
        }
      }
      if (lastInRow >= 0)
      {
        const std::lock_guard<std::mutex> lock(guard);
        first = glm::min(first, glm::ivec2(firstInRow, row));
        last = glm::max(last, glm::ivec2(lastInRow, row));
      }
    });
  if (last.x < 0)
  {
    return PixelRect();
  }
  const glm::ivec2 end = glm::min((last + 1) * TileSize, frame.Size);
  return { first * TileSize, end - first * TileSize };
}

bool IsOpaque(const PixelColor& color)
{
  return color[3] == 255;
}

bool IsTranslucent(const PixelColor& color)
{
  return color[3] != 0 && color[3] != 255;
}

/// True if a pixel of a tile has more than one layer: where a second round begins anew.
bool HasSecondRound(const std::vector<LayerHit>& layers)
{
  return std::adjacent_find(layers.begin(), layers.end(),
           [](const LayerHit& a, const LayerHit& b) { return b.Pixel <= a.Pixel; }) != layers.end();
}

}

float WindowDepthOf(const View& view, const glm::ivec2& pixel, double t)
{
  const Ray ray = view.RayThrough(pixel.x, pixel.y);
  const glm::dvec4 clip = view.ClipFromWorld * glm::dvec4(ray.Origin + t * ray.Direction, 1.0);
  return static_cast<float>(std::min(std::max(0.5 * clip.z / clip.w + 0.5, 0.0), 1.0));
}

void WindowPicture::Assign(const Frame& frame, const View& view)
{
  this->Rect = FindHits(frame);
  const auto width = static_cast<std::size_t>(this->Rect.Size.x);
  this->Colors.resize(width * static_cast<std::size_t>(this->Rect.Size.y));
  this->Depths.resize(this->Colors.size());
  std::atomic<bool> hasOpaque(false), hasTranslucent(false);
  ParallelFor(this->Rect.Size.y, RowGrain * TileSize,
    [&](std::int64_t row)
    {
      const glm::ivec2 first = this->Rect.First + glm::ivec2(0, row);
      const std::size_t from = PlaceOf(frame, first.x, first.y);
      const std::size_t to = static_cast<std::size_t>(row) * width;
      const PixelColor* const colors = &frame.Colors[from];
      std::copy_n(colors, width, &this->Colors[to]);
      if (!hasOpaque && std::any_of(colors, colors + width, IsOpaque))
      {
        hasOpaque = true;
      }
      if (!hasTranslucent && std::any_of(colors, colors + width, IsTranslucent))
      {
        hasTranslucent = true;
      }
      for (int x = 0; x < this->Rect.Size.x; ++x)
      {
        const auto column = static_cast<std::size_t>(x);
        this->Depths[to + column] = frame.Isovalues[from + column] == Frame::NoSurface
          ? 1.0f
          : WindowDepthOf(view, first + glm::ivec2(x, 0), frame.Depth[from + column]);
      }
    });
  this->HasOpaque = hasOpaque;
  this->HasTranslucent = hasTranslucent;
  this->HasLayers = std::any_of(frame.Layers.begin(), frame.Layers.end(), HasSecondRound);
}

}
