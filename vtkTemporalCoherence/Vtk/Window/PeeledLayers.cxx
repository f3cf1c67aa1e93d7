// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PeeledLayers.h"

#include "Scene/Parallel.h"
#include "Window/PixelRays.h"
#include "Window/WindowPicture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

using Layer = PeeledLayers::Layer;

/// Lists of layers, one for each pixel, in consecutive memory.
struct LayerLists
{
  std::vector<Layer> Layers;
  std::vector<std::size_t> Firsts;
};

using FineColor = PeeledLayers::FineColor;

constexpr std::uint16_t Opaque = 65535;

/// A layer's own colour, computed from two composites: with and without it.
FineColor OwnColor(const LayerColor& with, const LayerColor& without)
{
  const int passed = LayerColor::Steps + LayerColor::Half - without.Values[3];
  FineColor own{};
  for (std::size_t c = 0; c < own.size() && passed > 0; ++c)
  {
    const double share = static_cast<double>(with.Values[c] - without.Values[c]) / passed;
    own[c] = static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * Opaque));
  }
  return own;
}

/// The colour of an opaque surface, of which only bytes are known.
FineColor OwnColor(const PixelColor& color)
{
  constexpr int step = Opaque / 255;
  FineColor own;
  std::transform(color.begin(), color.end(), own.begin(),
    [](std::uint8_t value) { return static_cast<std::uint16_t>(step * value); });
  return own;
}

bool IsOpaque(const Layer& layer)
{
  return layer.Color[3] == Opaque;
}

/// Make room for all lists in consecutive memory.
/// \param counts of layers in each list
void MakeRoom(const std::vector<std::size_t>& counts, LayerLists& lists)
{
  lists.Firsts.resize(counts.size() + 1);
  lists.Firsts.front() = 0;
  std::partial_sum(counts.begin(), counts.end(), lists.Firsts.begin() + 1);
  lists.Layers.resize(lists.Firsts.back());
}

/// Add the layers of a tile, which come in rounds from front to back.
void FillWithLayers(const Frame& frame, const View& view, std::int64_t tile, LayerLists& lists)
{
  const glm::ivec2 first = PixelsOfTile(frame.Size, tile).First;
  std::array<std::size_t, TileSize * TileSize> filled{};
  std::array<LayerColor, TileSize * TileSize> seen;
  for (const LayerHit& hit : frame.Layers[static_cast<std::size_t>(tile)])
  {
    const glm::ivec2 pixel(hit.Pixel % frame.Size.x, hit.Pixel / frame.Size.x);
    const glm::ivec2 inTile = pixel - first;
    const auto at = static_cast<std::size_t>(inTile.y * TileSize + inTile.x);
    const std::size_t place = lists.Firsts[static_cast<std::size_t>(hit.Pixel)] + filled[at]++;
    lists.Layers[place] = { WindowDepthOf(view, pixel, hit.Depth), OwnColor(hit.Color, seen[at]) };
    seen[at] = hit.Color;
  }
}

/// Fill the lists of a tile with the hits of opaque surfaces, at most one for each pixel.
void FillWithHits(const Frame& frame, const View& view, std::int64_t tile, LayerLists& lists)
{
  const PixelRect part = PixelsOfTile(frame.Size, tile);
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    for (int x = part.First.x; x < part.First.x + part.Size.x; ++x)
    {
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
        static_cast<std::size_t>(x);
      if (frame.Isovalues[pixel] != Frame::NoSurface)
      {
        lists.Layers[lists.Firsts[pixel]] = { WindowDepthOf(view, { x, y }, frame.Depth[pixel]),
          OwnColor(frame.Colors[pixel]) };
      }
    }
  }
}

/// The layers of a frame, one list for each ray.
LayerLists ListsOf(const Frame& frame, const View& view)
{
  LayerLists lists;
  std::vector<std::size_t> counts(frame.Colors.size());
  const bool hasLayers = !frame.Layers.empty();
  if (hasLayers)
  {
    for (const std::vector<LayerHit>& ofTile : frame.Layers)
    {
      for (const LayerHit& layer : ofTile)
      {
        ++counts[static_cast<std::size_t>(layer.Pixel)];
      }
    }
  }
  else
  {
    std::transform(frame.Isovalues.begin(), frame.Isovalues.end(), counts.begin(),
      [](SurfaceIndex surface) { return surface == Frame::NoSurface ? 0u : 1u; });
  }
  MakeRoom(counts, lists);
  constexpr std::int64_t grain = 64;
  ParallelFor(NumberOfTiles(frame.Size), grain,
    [&](std::int64_t tile) {
      hasLayers ? FillWithLayers(frame, view, tile, lists) : FillWithHits(frame, view, tile, lists);
    });
  return lists;
}

/// Merge two sorted lists up to the first opaque layer.
/// \param to receives the layers; null: they are only counted
/// \return the number of layers
std::size_t Merge(
  const Layer* a, const Layer* endOfA, const Layer* b, const Layer* endOfB, Layer* to)
{
  std::size_t count = 0;
  while (a != endOfA || b != endOfB)
  {
    const bool isOfB = a == endOfA || (b != endOfB && b->Depth < a->Depth);
    const Layer& next = isOfB ? *b++ : *a++;
    if (to)
    {
      to[count] = next;
    }
    ++count;
    if (IsOpaque(next))
    {
      break;
    }
  }
  return count;
}

}

PeeledLayers PeeledLayers::Of(const Frame& frame, const View& view, bool isBlended)
{
  LayerLists lists = ListsOf(frame, view);
  // The first visible place of a volume may be the opaque prop that ends it. It must lie in front.
  constexpr float before = 1e-6f;
  for (std::size_t i = 0; isBlended && i < lists.Layers.size(); ++i)
  {
    lists.Layers[i].Depth = std::max(lists.Layers[i].Depth - before, 0.0f);
  }
  PeeledLayers own;
  own.Pixels = frame.Size;
  own.Layers.swap(lists.Layers);
  own.Firsts.swap(lists.Firsts);
  return own;
}

void PeeledLayers::Clear(const glm::ivec2& size)
{
  this->Pixels = size;
  this->Layers.clear();
  this->Firsts.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) + 1, 0);
}

void PeeledLayers::Add(const PeeledLayers& picture)
{
  const glm::ivec2 &size = this->Pixels, &rays = picture.Pixels;
  LayerLists all;
  std::vector<std::size_t> counts(this->Firsts.size() - 1);
  const auto forPixels = [&](const auto& work)
  {
    ParallelFor(size.y, 8,
      [&](std::int64_t y)
      {
        const std::int64_t row = (2 * y + 1) * rays.y / (2 * size.y) * rays.x;
        for (std::int64_t x = 0; x < size.x; ++x)
        {
          const std::int64_t ray = row + (2 * x + 1) * rays.x / (2 * size.x);
          work(static_cast<std::size_t>(y * size.x + x), static_cast<std::size_t>(ray));
        }
      });
  };
  const auto merge = [&](std::size_t pixel, std::size_t ray, Layer* to)
  {
    const Layer *const old = this->Layers.data(), *const next = picture.Layers.data();
    return Merge(old + this->Firsts[pixel], old + this->Firsts[pixel + 1],
      next + picture.Firsts[ray], next + picture.Firsts[ray + 1], to);
  };
  forPixels(
    [&](std::size_t pixel, std::size_t ray) { counts[pixel] = merge(pixel, ray, nullptr); });
  MakeRoom(counts, all);
  forPixels([&](std::size_t pixel, std::size_t ray)
    { merge(pixel, ray, all.Layers.data() + all.Firsts[pixel]); });
  this->Layers.swap(all.Layers);
  this->Firsts.swap(all.Firsts);
}

}
