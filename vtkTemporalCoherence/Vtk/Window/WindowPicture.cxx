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

/// Rows of tiles per task.
constexpr std::int64_t RowGrain = 2;

std::size_t PlaceOf(const Frame& frame, int x, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
}

/// True if a tile shows anything: a hit, or an edge beside one.
bool HasHits(const Frame& frame, std::int64_t tile)
{
  if (frame.ClearTiles[static_cast<std::size_t>(tile)] && !frame.IsAntialiased())
  {
    return false;
  }
  const PixelRect part = PixelsOfTile(frame.Size, tile);
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::size_t first = PlaceOf(frame, part.First.x, y);
    const SurfaceIndex* const row = &frame.Isovalues[first];
    if (std::any_of(
          row, row + part.Size.x, [](SurfaceIndex surface) { return surface != Frame::NoSurface; }))
    {
      return true;
    }
    const PixelColor* const colors = &frame.ShownColors()[first];
    if (frame.IsAntialiased() &&
      std::any_of(
        colors, colors + part.Size.x, [](const PixelColor& color) { return color[3] != 0; }))
    {
      return true;
    }
  }
  return false;
}

/// The smallest rectangle with all hits of a frame that WindowPicture::HitsGrain allows.
PixelRect FindHits(const Frame& frame)
{
  static_assert(WindowPicture::HitsGrain % TileSize == 0, "whole tiles");
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
  constexpr int grain = WindowPicture::HitsGrain;
  const glm::ivec2 begin = first * TileSize / grain * grain;
  const glm::ivec2 end = glm::min((last * TileSize / grain + 1) * grain, frame.Size);
  return { begin, end - begin };
}

/// The rectangle around new hits and the last ones, if that is not much larger than the new ones'.
PixelRect KeepRoom(const PixelRect& hits, const PixelRect& last, const glm::ivec2& size)
{
  constexpr int mostTimes = 2;
  const glm::ivec2 first = glm::min(hits.First, last.First);
  const glm::ivec2 end = glm::max(hits.First + hits.Size, last.First + last.Size);
  const glm::ivec2 both = end - first;
  const bool isLarge = static_cast<std::int64_t>(both.x) * both.y >
    static_cast<std::int64_t>(mostTimes) * hits.Size.x * hits.Size.y;
  return isLarge || last.Size.x == 0 || end != glm::min(end, size) ? hits
                                                                   : PixelRect{ first, both };
}

bool IsOpaque(const PixelColor& color)
{
  return color[3] == 255;
}

bool IsTranslucent(const PixelColor& color)
{
  return color[3] != 0 && color[3] != 255;
}

/// True if a pixel of a tile has several layers: then a second round begins.
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

namespace
{

/// The depth of the background.
constexpr float FarthestDepth = 1.0f;

/// The depth of an edge, of a pixel whose own ray misses: that of the nearest hit beside it.
float DepthBeside(const Frame& frame, const View& view, const glm::ivec2& ray)
{
  float nearest = FarthestDepth;
  const glm::ivec2 first = glm::max(ray - 1, 0), last = glm::min(ray + 1, frame.Size - 1);
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      const std::size_t place = PlaceOf(frame, x, y);
      if (frame.Isovalues[place] != Frame::NoSurface)
      {
        nearest = std::min(nearest, WindowDepthOf(view, { x, y }, frame.Depth[place]));
      }
    }
  }
  return nearest;
}

/// Work on the rows of a rectangle in parallel.
/// \param work is called with the row and the position of its first pixel in the rectangle's arrays
template <typename Work>
void ForRows(const PixelRect& rect, const Work& work)
{
  ParallelFor(rect.Size.y, RowGrain * TileSize,
    [&](std::int64_t row)
    {
      work(rect.First.y + static_cast<int>(row),
        static_cast<std::size_t>(row) * static_cast<std::size_t>(rect.Size.x));
    });
}

/// Collects the kinds of pixels in a picture, row by row, while rows are in the caches of threads.
struct PixelKinds
{
  void See(const PixelColor* row, int count)
  {
    // Flags are set, never cleared, so threads cannot overwrite each other's result.
    if (!this->Opaque && std::any_of(row, row + count, IsOpaque))
    {
      this->Opaque = true;
    }
    if (!this->Translucent && std::any_of(row, row + count, IsTranslucent))
    {
      this->Translucent = true;
    }
  }

  std::atomic<bool> Opaque{ false }, Translucent{ false };
};

/// One pixel for each ray.
void TakeRays(const Frame& frame, const View& view, WindowPicture& picture, PixelKinds& kinds)
{
  const PixelRect& rect = picture.Rect;
  ForRows(rect,
    [&](int y, std::size_t to)
    {
      const std::size_t from = PlaceOf(frame, rect.First.x, y);
      std::copy_n(&frame.ShownColors()[from], rect.Size.x, &picture.Colors[to]);
      kinds.See(&picture.Colors[to], rect.Size.x);
      for (int x = 0; x < rect.Size.x; ++x)
      {
        const auto column = static_cast<std::size_t>(x);
        const glm::ivec2 ray(rect.First.x + x, y);
        const bool isHit = frame.Isovalues[from + column] != Frame::NoSurface;
        picture.Depths[to + column] = isHit ? WindowDepthOf(view, ray, frame.Depth[from + column])
          : picture.Colors[to + column][3] != 0 ? DepthBeside(frame, view, ray)
                                                : FarthestDepth;
      }
    });
}

/// Several rays for each pixel.
void TakeMeans(const Frame& frame, const View& view, WindowPicture& picture, PixelKinds& kinds)
{
  const PixelRect& rect = picture.Rect;
  const PixelRays rays(frame.Size, picture.Size);
  const PixelRect all = { glm::ivec2(0), frame.Size };
  ForRows(rect,
    [&](int y, std::size_t to)
    {
      for (int x = 0; x < rect.Size.x; ++x)
      {
        const glm::ivec2 pixel(rect.First.x + x, y);
        const std::size_t place = to + static_cast<std::size_t>(x);
        const std::optional<glm::ivec2> shown = rays.Shown(frame, pixel);
        PixelColor& color = picture.Colors[place];
        color = shown || frame.IsAntialiased()
          ? rays.MeanColor(frame.ShownColors().data(), all, pixel)
          : PixelColor{};
        picture.Depths[place] = shown
          ? WindowDepthOf(view, *shown, frame.Depth[PlaceOf(frame, shown->x, shown->y)])
          : color[3] != 0 ? DepthBeside(frame, view, rays.AtCentre(pixel))
                          : FarthestDepth;
      }
      kinds.See(&picture.Colors[to], rect.Size.x);
    });
}

}

void WindowPicture::Assign(const Frame& frame, const View& view, const glm::ivec2& window)
{
  const PixelRays rays(frame.Size, window);
  this->Size = rays.AreMore() ? window : frame.Size;
  this->Hits = KeepRoom(FindHits(frame), this->Hits, frame.Size);
  this->Rect = rays.AreMore() ? rays.PixelsOf(this->Hits) : this->Hits;
  this->Colors.resize(
    static_cast<std::size_t>(this->Rect.Size.x) * static_cast<std::size_t>(this->Rect.Size.y));
  this->Depths.resize(this->Colors.size());
  PixelKinds kinds;
  rays.AreMore() ? TakeMeans(frame, view, *this, kinds) : TakeRays(frame, view, *this, kinds);
  this->HasOpaque = kinds.Opaque;
  this->HasTranslucent = kinds.Translucent;
  this->HasLayers = std::any_of(frame.Layers.begin(), frame.Layers.end(), HasSecondRound);
}

std::vector<PixelColor> WindowPicture::MeanColors(
  const Frame& frame, const std::vector<PixelColor>& colors) const
{
  const PixelRays rays(frame.Size, this->Size);
  std::vector<PixelColor> means(this->Colors.size());
  ForRows(this->Rect,
    [&](int y, std::size_t to)
    {
      for (int x = this->Rect.First.x; x < this->Rect.First.x + this->Rect.Size.x; ++x, ++to)
      {
        means[to] = rays.MeanColor(colors.data(), this->Hits, { x, y });
      }
    });
  return means;
}

}
