// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// How pixels between rays are filled.

#include "Render/RayGrid.h"
#include "Scene/LayerBatch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace TemporalCoherence
{
namespace
{

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

/// The four rays around some pixels: left to right, then upwards.
struct RayGrid::Cell
{
  using Color = std::array<float, 4>;

  std::array<std::size_t, 4> Ray;
  std::array<Color, 4> Colors;
  std::array<double, 4> Depth;
  std::array<bool, 4> IsHit;
  bool ShowsAnything = false;
  bool IsOneSurface = false; ///< all rays meet one, which is not seen too steeply

  /// The nearest ray among those that meet anything.
  /// \param right, above weights of the right and of the upper rays, in 256ths
  std::size_t Nearest(int right, int above) const
  {
    const std::size_t side = right > 128 ? 1 : 0, line = above > 128 ? 2 : 0;
    // The second nearest ray is the neighbour along the axis with the more even weights.
    const bool isAcross = std::abs(right - 128) < std::abs(above - 128);
    const std::size_t beside = isAcross ? 1 : 2;
    for (const std::size_t turned : { std::size_t(0), beside, beside ^ 3, std::size_t(3) })
    {
      if (this->IsHit[(side + line) ^ turned])
      {
        return (side + line) ^ turned;
      }
    }
    return 4;
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
  const SurfaceIndex surface = from.Isovalues[cell.Ray[0]];
  cell.IsOneSurface = surface != Frame::NoSurface;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t ray = cell.Ray[i];
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      cell.Colors[i][channel] = from.Colors[ray][channel];
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

namespace
{

/// Write a pixel that shows nothing.
void FillMiss(std::size_t pixel, Frame& frame)
{
  frame.Answers[pixel] = Answer::DefiniteMiss;
  frame.Colors[pixel] = {};
  frame.Depth[pixel] = std::numeric_limits<double>::infinity();
  frame.Normals[pixel] = glm::vec3(0.0f);
  frame.Isovalues[pixel] = Frame::NoSurface;
  frame.Kinds[pixel] = HitKind::None;
}

/// Interpolate with a weight in 256ths; the result is 256 times as large. Whole numbers stay exact
/// in floats: after two such steps, a byte has 24 bits at most.
std::array<float, 4> Mix(
  const std::array<float, 4>& a, const std::array<float, 4>& b, int weightOfB)
{
  const auto ofB = static_cast<float>(weightOfB), ofA = static_cast<float>(256 - weightOfB);
  std::array<float, 4> mixed;
  for (std::size_t channel = 0; channel < 4; ++channel)
  {
    mixed[channel] = ofA * a[channel] + ofB * b[channel];
  }
  return mixed;
}

double Mix(double a, double b, int weightOfB)
{
  return a + (b - a) * (weightOfB * (1.0 / 256));
}

}

/// Fill the pixels of a tile between four rays.
/// \param between the pixels
/// \return those that show anything, as bits of the tile
std::uint64_t RayGrid::FillCell(const PixelRect& between, const PixelRect& part, Frame& frame) const
{
  const Frame& from = this->Picture;
  const Cell cell = this->CellBetween(this->Columns[static_cast<std::size_t>(between.First.x)],
    this->Rows[static_cast<std::size_t>(between.First.y)]);
  std::uint64_t seen = 0;
  for (int y = between.First.y; y < between.First.y + between.Size.y; ++y)
  {
    const std::size_t line = PlaceOf(frame, 0, y);
    const int above = this->Rows[static_cast<std::size_t>(y)].Weight;
    const Cell::Color left = Mix(cell.Colors[0], cell.Colors[2], above);
    const Cell::Color right = Mix(cell.Colors[1], cell.Colors[3], above);
    const double leftDepth = Mix(cell.Depth[0], cell.Depth[2], above);
    const double rightDepth = Mix(cell.Depth[1], cell.Depth[3], above);
    for (int x = between.First.x; x < between.First.x + between.Size.x; ++x)
    {
      const std::size_t pixel = line + static_cast<std::size_t>(x);
      const int weight = this->Columns[static_cast<std::size_t>(x)].Weight;
      const Cell::Color mixed = Mix(left, right, weight);
      std::array<std::uint8_t, 4> color;
      for (std::size_t channel = 0; channel < 4; ++channel)
      {
        color[channel] =
          static_cast<std::uint8_t>(static_cast<int>(mixed[channel] * (1.0f / 65536) + 0.5f));
      }
      const bool isSeen = cell.ShowsAnything && (color[0] | color[1] | color[2] | color[3]) != 0;
      if (!isSeen)
      {
        FillMiss(pixel, frame);
        continue;
      }
      const std::size_t nearest = cell.Nearest(weight, above), ray = cell.Ray[nearest];
      frame.Answers[pixel] = Answer::DefiniteHit;
      frame.Colors[pixel] = color;
      frame.Depth[pixel] =
        cell.IsOneSurface ? Mix(leftDepth, rightDepth, weight) : cell.Depth[nearest];
      frame.Normals[pixel] = from.Normals[ray];
      frame.Isovalues[pixel] = from.Isovalues[ray];
      frame.Kinds[pixel] = from.Kinds[ray];
      const int bit = (y - part.First.y) * part.Size.x + x - part.First.x;
      seen |= std::uint64_t(1) << bit;
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
    const SurfaceIndex* const row = &this->Picture.Isovalues[PlaceOf(this->Picture, 0, y)];
    if (std::any_of(row + around.First.x, row + around.First.x + around.Size.x,
          [](SurfaceIndex surface) { return surface != Frame::NoSurface; }))
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
