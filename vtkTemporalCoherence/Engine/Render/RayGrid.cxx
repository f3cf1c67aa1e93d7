// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/RayGrid.h"

#include "Scene/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace TemporalCoherence
{
namespace
{

/// Rows of rays per task.
constexpr std::int64_t RowGrain = 8;

std::size_t PlaceOf(const Frame& frame, int x, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
}

}

RayGrid::RayGrid(const Frame& picture, const FrameKey& key)
  : Picture(picture)
  , Key(key)
  , Columns(PlacesOf(key.View.Size.x, picture.Size.x))
  , Rows(PlacesOf(key.View.Size.y, picture.Size.y))
{
  const View& view = key.View;
  const glm::dvec2 perRay = 2.0 / glm::dvec2(picture.Size);
  this->Spacing =
    std::max(perRay.x * glm::length(view.OriginX), perRay.y * glm::length(view.OriginY));
  this->PerDistance =
    std::max(perRay.x * glm::length(view.DirectionX), perRay.y * glm::length(view.DirectionY));
}

std::vector<RayGrid::Place> RayGrid::PlacesOf(int pixels, int rays)
{
  // A pixel's centre, in halves of pixels and counted from the first ray, times the number of rays.
  std::vector<Place> places;
  places.reserve(static_cast<std::size_t>(pixels));
  const std::int64_t unit = 2 * std::int64_t(pixels);
  for (int pixel = 0; pixel < pixels; ++pixel)
  {
    const std::int64_t at =
      std::clamp<std::int64_t>((2 * std::int64_t(pixel) + 1) * rays - pixels, 0, (rays - 1) * unit);
    const auto first = static_cast<int>(at / unit);
    const auto weight = static_cast<int>((256 * (at % unit) + pixels) / unit);
    places.push_back({ first, std::min(first + 1, rays - 1), weight });
  }
  return places;
}

/// The end of the pixels that lie between the same rays as pixel `first`.
int RayGrid::EndOf(const std::vector<Place>& places, int first, int end)
{
  const auto at = [&](int pixel) { return places[static_cast<std::size_t>(pixel)].First; };
  int next = first + 1;
  while (next < end && at(next) == at(first))
  {
    ++next;
  }
  return next;
}

/// The mean difference between a ray's colour and the mean of its neighbours, for each ray.
std::vector<float> RayGrid::FindBends() const
{
  const Frame& picture = this->Picture;
  const glm::ivec2 size = picture.Size;
  std::vector<float> bends(picture.Colors.size());
  ParallelFor(size.y, RowGrain,
    [&](std::int64_t row)
    {
      const auto y = static_cast<int>(row);
      for (int x = 0; x < size.x; ++x)
      {
        const auto color = [&](int column, int line) -> const std::array<std::uint8_t, 4>&
        {
          return picture.Colors[PlaceOf(
            picture, std::clamp(column, 0, size.x - 1), std::clamp(line, 0, size.y - 1))];
        };
        const auto &here = color(x, y), &left = color(x - 1, y), &right = color(x + 1, y);
        const auto &below = color(x, y - 1), &above = color(x, y + 1);
        int sum = 0;
        for (std::size_t channel = 0; channel < 4; ++channel)
        {
          sum += std::abs(
            4 * here[channel] - left[channel] - right[channel] - below[channel] - above[channel]);
        }
        bends[PlaceOf(picture, x, y)] = static_cast<float>(sum) / 16.0f;
      }
    });
  return bends;
}

/// The rays between which the pixels of a tile lie.
PixelRect RayGrid::RaysAround(const PixelRect& part) const
{
  const glm::ivec2 last = part.First + part.Size - 1;
  const glm::ivec2 first(this->Columns[static_cast<std::size_t>(part.First.x)].First,
    this->Rows[static_cast<std::size_t>(part.First.y)].First);
  const glm::ivec2 end(this->Columns[static_cast<std::size_t>(last.x)].Second + 1,
    this->Rows[static_cast<std::size_t>(last.y)].Second + 1);
  return { first, end - first };
}

std::vector<float> RayGrid::FindDoubts() const
{
  // In a tile without any difference, something may still hide between the rays.
  constexpr float least = 1e-3f;
  const std::vector<float> bends = this->FindBends();
  const glm::ivec2 pixels = this->Key.View.Size;
  std::vector<float> doubts(static_cast<std::size_t>(NumberOfTiles(pixels)));
  ParallelFor(static_cast<std::int64_t>(doubts.size()), TileGrain,
    [&](std::int64_t tile)
    {
      const PixelRect part = PixelsOfTile(pixels, tile);
      const PixelRect around = this->RaysAround(part);
      float sum = 0.0f;
      for (int y = around.First.y; y < around.First.y + around.Size.y; ++y)
      {
        for (int x = around.First.x; x < around.First.x + around.Size.x; ++x)
        {
          sum += bends[PlaceOf(this->Picture, x, y)];
        }
      }
      doubts[static_cast<std::size_t>(tile)] =
        least + sum / static_cast<float>(around.Size.x * around.Size.y);
    });
  return doubts;
}

}
