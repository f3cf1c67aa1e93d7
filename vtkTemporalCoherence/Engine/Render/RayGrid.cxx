// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/RayGrid.h"

#include "Scene/LayerBatch.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>

namespace TemporalCoherence
{
namespace
{

/// Rows of rays per task.
constexpr std::int64_t RowGrain = 8;

/// Rays meet one surface if their distances differ by no more than this many spacings of rays: the
/// surface is seen at 14 degrees or more.
constexpr double Steepest = 4.0;

std::size_t PlaceOf(const Frame& frame, int x, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
}

/// The composite of all layers of a pixel, as one layer.
LayerHit MergedLayer(const Frame& frame, std::size_t pixel)
{
  LayerHit hit{ frame.Depth[pixel], static_cast<std::int32_t>(pixel), frame.Isovalues[pixel],
    frame.Kinds[pixel] };
  for (std::size_t channel = 0; channel < 4; ++channel)
  {
    hit.Color.Values[channel] =
      static_cast<std::uint16_t>(frame.Colors[pixel][channel] << 8 | LayerColor::Half);
  }
  return hit;
}

}

FrameKey KeyOfGrid(const FrameKey& key, const glm::ivec2& rays)
{
  FrameKey fewer = key;
  const glm::ivec2 pixels = key.View.Size;
  fewer.View.Size = rays;
  if (key.IsBlended() && key.Blended().Ends)
  {
    // A ray ends where the pixel around it does.
    const std::vector<double>& ends = *key.Blended().Ends;
    auto ofRays = std::make_shared<std::vector<double>>();
    ofRays->reserve(static_cast<std::size_t>(rays.x) * static_cast<std::size_t>(rays.y));
    const auto pixelAt = [](int ray, int of, int size)
    { return (2 * std::int64_t(ray) + 1) * size / (2 * std::int64_t(of)); };
    for (int y = 0; y < rays.y; ++y)
    {
      const std::int64_t row = pixelAt(y, rays.y, pixels.y) * pixels.x;
      for (int x = 0; x < rays.x; ++x)
      {
        ofRays->push_back(ends[static_cast<std::size_t>(row + pixelAt(x, rays.x, pixels.x))]);
      }
    }
    fewer.Blended().Ends = ofRays;
  }
  return fewer;
}

RayGrid::RayGrid(const Frame& picture, const FrameKey& key)
  : Picture(picture)
  , Key(key)
  , Columns(PlacesOf(key.View.Size.x, picture.Size.x))
  , Rows(PlacesOf(key.View.Size.y, picture.Size.y))
{
  const View& view = key.View;
  const glm::dvec2 perRay = 2.0 / glm::dvec2(picture.Size);
  this->Spacing = std::max(perRay.x * glm::length(view.OriginX), perRay.y * glm::length(view.OriginY));
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
    const std::int64_t at = std::clamp<std::int64_t>(
      (2 * std::int64_t(pixel) + 1) * rays - pixels, 0, (rays - 1) * unit);
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
          sum += std::abs(4 * here[channel] - left[channel] - right[channel] - below[channel] -
            above[channel]);
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

/// The four rays around some pixels.
struct RayGrid::Cell
{
  /// Left to right, then upwards.
  std::array<std::size_t, 4> Ray;
  std::array<std::array<float, 4>, 4> Color; ///< of each ray, by channel
  std::array<double, 4> Depth;
  std::array<bool, 4> IsHit;
  bool ShowsAnything = false;
  bool IsOneSurface = false; ///< all rays meet one, which is not seen too steeply

  /// The ray with the largest weight among those that meet anything.
  std::size_t Nearest(const std::array<float, 4>& weights) const
  {
    std::size_t nearest = 4;
    for (std::size_t i = 0; i < 4; ++i)
    {
      nearest = this->IsHit[i] && (nearest == 4 || weights[i] > weights[nearest]) ? i : nearest;
    }
    return nearest;
  }
};

RayGrid::Cell RayGrid::CellBetween(const Place& column, const Place& row) const
{
  const Frame& from = this->Picture;
  const std::size_t below = PlaceOf(from, 0, row.First), above = PlaceOf(from, 0, row.Second);
  const auto left = static_cast<std::size_t>(column.First);
  const auto right = static_cast<std::size_t>(column.Second);
  Cell cell;
  cell.Ray = { below + left, below + right, above + left, above + right };
  const std::int16_t surface = from.Isovalues[cell.Ray[0]];
  cell.IsOneSurface = surface != Frame::NoSurface;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t ray = cell.Ray[i];
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      cell.Color[i][channel] = from.Colors[ray][channel];
    }
    cell.Depth[i] = from.Depth[ray];
    cell.IsHit[i] = from.Isovalues[ray] != Frame::NoSurface;
    cell.ShowsAnything |= cell.IsHit[i];
    cell.IsOneSurface &= from.Isovalues[ray] == surface;
  }
  const auto [near, far] = std::minmax_element(cell.Depth.begin(), cell.Depth.end());
  cell.IsOneSurface = cell.IsOneSurface &&
    *far - *near <= Steepest * (this->Spacing + this->PerDistance * std::abs(*far));
  return cell;
}

/// Write a pixel that shows nothing.
void RayGrid::FillMiss(std::size_t pixel, Frame& frame)
{
  frame.Answers[pixel] = Answer::DefiniteMiss;
  frame.Colors[pixel] = {};
  frame.Depth[pixel] = std::numeric_limits<double>::infinity();
  frame.Normals[pixel] = glm::vec3(0.0f);
  frame.Isovalues[pixel] = Frame::NoSurface;
  frame.Kinds[pixel] = HitKind::None;
}

/// \param weights of the rays, in 65536ths. Sums of such multiples of bytes are exact in floats
/// \return true if the pixel shows anything
bool RayGrid::FillPixel(
  const Cell& cell, const std::array<float, 4>& weights, std::size_t pixel, Frame& frame) const
{
  std::array<std::uint8_t, 4> color;
  int all = 0;
  for (std::size_t channel = 0; channel < 4; ++channel)
  {
    const float sum = 32768.0f + weights[0] * cell.Color[0][channel] +
      weights[1] * cell.Color[1][channel] + weights[2] * cell.Color[2][channel] +
      weights[3] * cell.Color[3][channel];
    const auto byte = static_cast<int>(sum * (1.0f / 65536));
    color[channel] = static_cast<std::uint8_t>(byte);
    all |= byte;
  }
  if (all == 0)
  {
    FillMiss(pixel, frame);
    return false;
  }
  const Frame& from = this->Picture;
  const std::size_t nearest = cell.Nearest(weights), ray = cell.Ray[nearest];
  double depth = cell.Depth[nearest];
  if (cell.IsOneSurface)
  {
    depth = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      depth += static_cast<double>(weights[i]) * (1.0 / 65536) * cell.Depth[i];
    }
  }
  frame.Answers[pixel] = Answer::DefiniteHit;
  frame.Colors[pixel] = color;
  frame.Depth[pixel] = depth;
  frame.Normals[pixel] = from.Normals[ray];
  frame.Isovalues[pixel] = from.Isovalues[ray];
  frame.Kinds[pixel] = from.Kinds[ray];
  return true;
}

/// Fill the pixels of a tile between four rays.
/// \param between the pixels
/// \return those that show anything, as bits of the tile
std::uint64_t RayGrid::FillCell(
  const PixelRect& between, const PixelRect& part, Frame& frame) const
{
  const Place& column = this->Columns[static_cast<std::size_t>(between.First.x)];
  const Cell cell =
    this->CellBetween(column, this->Rows[static_cast<std::size_t>(between.First.y)]);
  std::uint64_t seen = 0;
  for (int y = between.First.y; y < between.First.y + between.Size.y; ++y)
  {
    const std::size_t line = PlaceOf(frame, 0, y);
    const int above = this->Rows[static_cast<std::size_t>(y)].Weight;
    for (int x = between.First.x; x < between.First.x + between.Size.x; ++x)
    {
      const std::size_t pixel = line + static_cast<std::size_t>(x);
      if (!cell.ShowsAnything)
      {
        FillMiss(pixel, frame);
        continue;
      }
      const int right = this->Columns[static_cast<std::size_t>(x)].Weight;
      const std::array<float, 4> weights{ static_cast<float>((256 - right) * (256 - above)),
        static_cast<float>(right * (256 - above)), static_cast<float>((256 - right) * above),
        static_cast<float>(right * above) };
      const int bit = (y - part.First.y) * part.Size.x + x - part.First.x;
      seen |= std::uint64_t(this->FillPixel(cell, weights, pixel, frame)) << bit;
    }
  }
  return seen;
}

/// True if a ray around a tile meets anything.
bool RayGrid::ShowsAnything(const PixelRect& part) const
{
  const PixelRect around = this->RaysAround(part);
  for (int y = around.First.y; y < around.First.y + around.Size.y; ++y)
  {
    const std::int16_t* const row = &this->Picture.Isovalues[PlaceOf(this->Picture, 0, y)];
    if (std::any_of(row + around.First.x, row + around.First.x + around.Size.x,
          [](std::int16_t surface) { return surface != Frame::NoSurface; }))
    {
      return true;
    }
  }
  return false;
}

TraceCounts RayGrid::Fill(std::int64_t tile, const PixelRect& part, Frame& frame) const
{
  TraceCounts counts;
  const auto place = static_cast<std::size_t>(tile);
  const int pixels = part.Size.x * part.Size.y;
  const bool hasLayers = !frame.Layers.empty();
  if (hasLayers)
  {
    frame.Layers[place].clear();
    frame.Behind[place] = {};
  }
  if (!this->ShowsAnything(part))
  {
    StoreMisses(tile, part, this->Key.View.Parallel, frame);
    counts.DefiniteMisses = pixels;
    return counts;
  }
  frame.ClearTiles[place] = 0;
  std::uint64_t seen = 0;
  const glm::ivec2 end = part.First + part.Size;
  glm::ivec2 next(part.First);
  for (int y = part.First.y; y < end.y; y = next.y)
  {
    next.y = EndOf(this->Rows, y, end.y);
    for (int x = part.First.x; x < end.x; x = next.x)
    {
      next.x = EndOf(this->Columns, x, end.x);
      seen |= this->FillCell({ { x, y }, next - glm::ivec2(x, y) }, part, frame);
    }
    for (int line = y; line < next.y && !frame.Cells.empty(); ++line)
    {
      std::fill_n(&frame.Cells[PlaceOf(frame, part.First.x, line)], part.Size.x, NoCell);
    }
  }
  if (hasLayers)
  {
    frame.Behind[place].Merged = seen;
    frame.Layers[place].reserve(hwy::PopCount(seen));
    ForEachRay(seen,
      [&](std::size_t i)
      {
        const auto at = static_cast<int>(i);
        const std::size_t pixel =
          PlaceOf(frame, part.First.x + at % part.Size.x, part.First.y + at / part.Size.x);
        frame.Layers[place].push_back(MergedLayer(frame, pixel));
      });
  }
  counts.DefiniteHits = static_cast<std::int64_t>(hwy::PopCount(seen));
  counts.DefiniteMisses = pixels - counts.DefiniteHits;
  return counts;
}

}
