// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/EdgePixels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace TemporalCoherence
{
namespace
{

/// Colours of neighbours differ by more than this at an edge, in steps of a byte.
constexpr std::uint8_t LeastContrast = 16;

/// Normals of neighbours enclose a larger angle at edges: 11 degrees, whose cosine this is.
constexpr float LeastCosine = 0.98f;

constexpr std::size_t Channels = 4;

/// The colours of a row of a tile, and of the pixels beside it.
using ColorRow = std::array<std::uint8_t, Channels*(TileSize + 2)>;
/// A number for each channel of a row of a tile.
using TileRow = std::array<std::uint8_t, Channels * TileSize>;

/// Take a row. Beyond the picture, its last pixels are repeated.
ColorRow TakeRow(const Frame& frame, const PixelRect& part, int y)
{
  const int row = glm::clamp(y, 0, frame.Size.y - 1) * frame.Size.x;
  ColorRow taken;
  if (part.First.x > 0 && part.First.x + TileSize < frame.Size.x)
  {
    std::memcpy(
      taken.data(), &frame.Colors[static_cast<std::size_t>(row + part.First.x - 1)], taken.size());
    return taken;
  }
  for (int i = 0; i < TileSize + 2; ++i)
  {
    const int x = glm::clamp(part.First.x + i - 1, 0, frame.Size.x - 1);
    std::memcpy(&taken[Channels * static_cast<std::size_t>(i)],
      &frame.Colors[static_cast<std::size_t>(row + x)], Channels);
  }
  return taken;
}

/// Find pixels that differ in a channel from the least or the largest value around them.
std::uint64_t FindByColors(const Frame& frame, const PixelRect& part)
{
  constexpr std::size_t rows = TileSize + 2;
  std::array<TileRow, rows> own, low, high;
  for (std::size_t row = 0; row < rows; ++row)
  {
    const ColorRow colors = TakeRow(frame, part, part.First.y + static_cast<int>(row) - 1);
    for (std::size_t i = 0; i < own[row].size(); ++i) // in vectors
    {
      const std::uint8_t left = colors[i], middle = colors[i + Channels];
      const std::uint8_t right = colors[i + 2 * Channels];
      own[row][i] = middle;
      low[row][i] = std::min(std::min(left, middle), right);
      high[row][i] = std::max(std::max(left, middle), right);
    }
  }
  std::uint64_t edges = 0;
  for (int y = 0; y < part.Size.y; ++y)
  {
    const auto row = static_cast<std::size_t>(y) + 1;
    TileRow differ;
    for (std::size_t i = 0; i < differ.size(); ++i) // in vectors
    {
      const std::uint8_t least = std::min(std::min(low[row - 1][i], low[row][i]), low[row + 1][i]);
      const std::uint8_t most =
        std::max(std::max(high[row - 1][i], high[row][i]), high[row + 1][i]);
      const auto below = static_cast<std::uint8_t>(own[row][i] - least);
      const auto above = static_cast<std::uint8_t>(most - own[row][i]);
      differ[i] = std::max(below, above) > LeastContrast ? 1 : 0;
    }
    for (int x = 0; x < part.Size.x; ++x)
    {
      std::uint32_t any;
      std::memcpy(&any, &differ[Channels * static_cast<std::size_t>(x)], sizeof(any));
      edges |= std::uint64_t(any != 0) << (y * part.Size.x + x);
    }
  }
  return edges;
}

bool DifferByNormal(const Frame& frame, std::size_t a, std::size_t b)
{
  const bool isMiss = frame.Isovalues[a] == Frame::NoSurface;
  return frame.Isovalues[a] != frame.Isovalues[b] ||
    (!isMiss && glm::dot(frame.Normals[a], frame.Normals[b]) < LeastCosine);
}

/// Find pixels that show another surface than a neighbour, or have another normal.
std::uint64_t FindByNormals(const Frame& frame, const PixelRect& part)
{
  const auto placeOf = [&](const glm::ivec2& pixel)
  { return static_cast<std::size_t>(pixel.y * frame.Size.x + pixel.x); };
  std::uint64_t edges = 0;
  for (int place = 0; place < part.Size.x * part.Size.y; ++place)
  {
    const glm::ivec2 pixel = part.First + glm::ivec2(place % part.Size.x, place / part.Size.x);
    const glm::ivec2 first = glm::max(pixel - 1, 0), last = glm::min(pixel + 1, frame.Size - 1);
    bool differs = false;
    for (int y = first.y; y <= last.y; ++y)
    {
      for (int x = first.x; x <= last.x && !differs; ++x)
      {
        differs = DifferByNormal(frame, placeOf(pixel), placeOf({ x, y }));
      }
    }
    edges |= std::uint64_t(differs) << place;
  }
  return edges;
}

/// True if a tile and those around it hold misses only.
bool IsClear(const Frame& frame, const PixelRect& part)
{
  const glm::ivec2 tiles = TilesOf(frame.Size), at = part.First / TileSize;
  const glm::ivec2 first = glm::max(at - 1, 0), last = glm::min(at + 1, tiles - 1);
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

}

std::uint64_t FindEdges(const Frame& frame, const PixelRect& part, EdgeSign sign)
{
  if (IsClear(frame, part))
  {
    return 0;
  }
  return sign == EdgeSign::Colors ? FindByColors(frame, part) : FindByNormals(frame, part);
}

}
