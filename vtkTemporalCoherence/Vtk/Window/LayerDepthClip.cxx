// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/LayerDepthClip.h"

#include "Scene/Parallel.h"
#include "Window/WindowPicture.h"

#include <atomic>

namespace TemporalCoherence
{
namespace
{

/// The depth of the background.
constexpr float FarthestDepth = 1.0f;

/// Clips layers tile by tile. Tiles share no pixel of the window.
class LayerDepthClipper
{
public:
  LayerDepthClipper(const std::vector<float>& depths, const glm::ivec2& size, const PixelRect& rect,
    const Frame& frame, const TemporalCoherence::View& view, std::vector<PixelColor>& colors)
    : Depths(depths)
    , WindowSize(size)
    , Rect(rect)
    , Picture(frame)
    , View(view)
    , Colors(colors)
  {
  }

  /// Colour the window's pixels in a tile.
  /// \return true if a pixel differs from the picture's own colour
  bool Clip(std::int64_t tile) const
  {
    const PixelRect part = PixelsOfTile(this->Picture.Size, tile);
    if (this->HasDepths(part))
    {
      // Layers come from front to back: the last visible one stays.
      for (const LayerHit& layer : this->Picture.Layers[static_cast<std::size_t>(tile)])
      {
        this->Show(layer);
      }
    }
    return this->Complete(part);
  }

private:
  /// True if the window shows a prop in a part of the picture.
  bool HasDepths(const PixelRect& part) const
  {
    bool isThere = false;
    const auto look = [&](std::size_t at) { isThere |= this->Depths[at] < FarthestDepth; };
    this->ForWindowPixels(part, look);
    return isThere;
  }

  void Show(const LayerHit& layer) const
  {
    const glm::ivec2 pixel(layer.Pixel % this->Picture.Size.x, layer.Pixel / this->Picture.Size.x);
    const float depth = WindowDepthOf(this->View, pixel, layer.Depth);
    this->ForWindowPixels({ pixel, glm::ivec2(1) },
      [&](std::size_t at)
      {
        if (depth <= this->Depths[at])
        {
          this->Colors[at] = layer.Color.Bytes();
        }
      });
  }

  /// Give pixels the picture's colours if none or all of their layers are clipped.
  bool Complete(const PixelRect& part) const
  {
    bool isCut = false;
    for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
    {
      for (int x = part.First.x; x < part.First.x + part.Size.x; ++x)
      {
        const auto pixel = static_cast<std::size_t>(y * this->Picture.Size.x + x);
        const PixelColor& ofLayers = this->Picture.Colors[pixel];
        const PixelColor& all = this->Picture.ShownColors()[pixel];
        this->ForWindowPixels({ { x, y }, glm::ivec2(1) },
          [&](std::size_t at)
          {
            PixelColor& color = this->Colors[at];
            color = color[3] == 0 || color == ofLayers ? all : color;
            isCut |= color != all;
          });
      }
    }
    return isCut;
  }

  /// Call work(position in the window's arrays) for each pixel of the window whose centre is in
  /// `part` of the picture.
  template <typename Work>
  void ForWindowPixels(const PixelRect& part, const Work& work) const
  {
    const glm::ivec2 first = this->FirstInWindow(part.First - this->Rect.First);
    const glm::ivec2 end = this->FirstInWindow(part.First + part.Size - this->Rect.First);
    for (int y = first.y; y < end.y; ++y)
    {
      for (int x = first.x; x < end.x; ++x)
      {
        work(static_cast<std::size_t>(y) * static_cast<std::size_t>(this->WindowSize.x) +
          static_cast<std::size_t>(x));
      }
    }
  }

  /// The first pixel of the window, in x and in y, whose centre is in pixel `from` or after it.
  glm::ivec2 FirstInWindow(const glm::ivec2& from) const
  {
    const glm::ivec2& size = this->Rect.Size;
    return (2 * from * this->WindowSize + size - 1) / (2 * size);
  }

  const std::vector<float>& Depths;
  glm::ivec2 WindowSize;
  PixelRect Rect;
  const Frame& Picture;
  const TemporalCoherence::View& View;
  std::vector<PixelColor>& Colors;
};

}

bool ClipLayersAt(const std::vector<float>& depths, const glm::ivec2& size, const PixelRect& rect,
  const Frame& frame, const View& view, std::vector<PixelColor>& colors)
{
  colors.assign(depths.size(), PixelColor{});
  const LayerDepthClipper clipper(depths, size, rect, frame, view, colors);
  const glm::ivec2 first = rect.First / TileSize, tiles = TilesOf(rect.Size);
  const int columns = TilesOf(frame.Size).x;
  std::atomic<bool> isCut(false);
  ParallelFor(tiles.y, 1,
    [&](std::int64_t row)
    {
      for (int column = 0; column < tiles.x; ++column)
      {
        if (clipper.Clip((first.y + row) * columns + first.x + column))
        {
          isCut = true;
        }
      }
    });
  return isCut;
}

}
