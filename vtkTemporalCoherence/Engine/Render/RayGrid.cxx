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

RayGrid::Corners RayGrid::CornersOf(int x, int y) const
{
  const Place &column = this->Columns[static_cast<std::size_t>(x)],
              &row = this->Rows[static_cast<std::size_t>(y)];
  const std::size_t below = PlaceOf(this->Picture, 0, row.First);
  const std::size_t above = PlaceOf(this->Picture, 0, row.Second);
  const auto left = static_cast<std::size_t>(column.First);
  const auto right = static_cast<std::size_t>(column.Second);
  const int rightWeight = column.Weight, leftWeight = 256 - rightWeight;
  const int aboveWeight = row.Weight, belowWeight = 256 - aboveWeight;
  return { { below + left, below + right, above + left, above + right },
    { leftWeight * belowWeight, rightWeight * belowWeight, leftWeight * aboveWeight,
      rightWeight * aboveWeight } };
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

bool RayGrid::MeetOneSurface(const Corners& corners) const
{
  const Frame& from = this->Picture;
  const std::int16_t surface = from.Isovalues[corners.Ray[0]];
  double near = from.Depth[corners.Ray[0]], far = near;
  for (const std::size_t ray : corners.Ray)
  {
    if (surface == Frame::NoSurface || from.Isovalues[ray] != surface)
    {
      return false;
    }
    near = std::min(near, from.Depth[ray]);
    far = std::max(far, from.Depth[ray]);
  }
  return far - near <= Steepest * (this->Spacing + this->PerDistance * std::abs(far));
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

/// \return true if the pixel shows anything
bool RayGrid::FillPixel(const Corners& corners, std::size_t pixel, Frame& frame) const
{
  const Frame& from = this->Picture;
  int nearest = -1, weightOfNearest = -1;
  for (int i = 0; i < 4; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const bool isHit = from.Isovalues[corners.Ray[at]] != Frame::NoSurface;
    if (isHit && corners.Weight[at] > weightOfNearest)
    {
      nearest = i;
      weightOfNearest = corners.Weight[at];
    }
  }
  std::array<std::uint8_t, 4> color{};
  int all = 0;
  for (std::size_t channel = 0; channel < 4 && nearest >= 0; ++channel)
  {
    int sum = 1 << 15;
    for (std::size_t i = 0; i < 4; ++i)
    {
      sum += corners.Weight[i] * from.Colors[corners.Ray[i]][channel];
    }
    color[channel] = static_cast<std::uint8_t>(sum >> 16);
    all += color[channel];
  }
  if (all == 0)
  {
    FillMiss(pixel, frame);
    return false;
  }
  const std::size_t ray = corners.Ray[static_cast<std::size_t>(nearest)];
  frame.Answers[pixel] = Answer::DefiniteHit;
  frame.Colors[pixel] = color;
  frame.Depth[pixel] = from.Depth[ray];
  frame.Normals[pixel] = from.Normals[ray];
  frame.Isovalues[pixel] = from.Isovalues[ray];
  frame.Kinds[pixel] = from.Kinds[ray];
  if (this->MeetOneSurface(corners))
  {
    double depth = 0.0;
    glm::vec3 normal(0.0f);
    for (std::size_t i = 0; i < 4; ++i)
    {
      depth += corners.Weight[i] * (1.0 / 65536) * from.Depth[corners.Ray[i]];
      normal += static_cast<float>(corners.Weight[i]) * from.Normals[corners.Ray[i]];
    }
    const float length = glm::length(normal);
    frame.Depth[pixel] = depth;
    frame.Normals[pixel] = length > 0.0f ? normal / length : frame.Normals[pixel];
  }
  return true;
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
  for (int i = 0; i < pixels; ++i)
  {
    const int x = part.First.x + i % part.Size.x, y = part.First.y + i / part.Size.x;
    const std::size_t pixel = PlaceOf(frame, x, y);
    seen |= std::uint64_t(this->FillPixel(this->CornersOf(x, y), pixel, frame)) << i;
    if (!frame.Cells.empty())
    {
      frame.Cells[pixel] = NoCell;
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
