// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Tiles_h
#define TemporalCoherence_Tiles_h

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Pictures are worked on in tiles of 8 x 8 pixels, row by row from the lower left.
constexpr int TileBits = 3;
constexpr int TileSize = 1 << TileBits; ///< pixels along an edge of a tile

/// Neighbouring tiles that one thread takes at a time: enough to share cached data, few enough to
/// balance the load. Measured by `Benchmark --scenarios routes,threads`.
constexpr std::int64_t TileGrain = 8;

/// The part of a picture that a stage works on: pixels First .. First + Size - 1.
struct PixelRect
{
  glm::ivec2 First{ 0 }, Size{ 0 };
};

/// Tiles along each axis of a picture of `pixels`.
inline glm::ivec2 TilesOf(const glm::ivec2& pixels)
{
  return (pixels + TileSize - 1) / TileSize;
}

inline std::int64_t NumberOfTiles(const glm::ivec2& pixels)
{
  const glm::ivec2 tiles = TilesOf(pixels);
  return static_cast<std::int64_t>(tiles.x) * tiles.y;
}

inline PixelRect PixelsOfTile(const glm::ivec2& pixels, std::int64_t tile)
{
  const int columns = TilesOf(pixels).x;
  const glm::ivec2 first =
    TileSize * glm::ivec2(static_cast<int>(tile % columns), static_cast<int>(tile / columns));
  return { first, glm::min(glm::ivec2(TileSize), pixels - first) };
}

/// Finds the places of pixels in their tile, row by row.
class PlaceFinder
{
public:
  /// \param part  the pixels of the tile
  /// \param width of the picture
  PlaceFinder(const PixelRect& part, int width)
    : First(part.First.y * width + part.First.x)
    , RowEnd(width - part.Size.x)
    , PerWidth((std::uint64_t(1) << 32) / static_cast<std::uint64_t>(width) + 1)
  {
  }

  /// \param pixel position in the picture, row by row
  std::size_t Find(std::int32_t pixel) const
  {
    const std::int32_t behind = pixel - this->First;
    const auto row =
      static_cast<std::int32_t>(static_cast<std::uint64_t>(behind) * this->PerWidth >> 32);
    return static_cast<std::size_t>(behind - row * this->RowEnd);
  }

private:
  std::int32_t First;  ///< pixel of the tile
  std::int32_t RowEnd; ///< pixels between its rows
  /// 1 / width in units of 2^-32, rounded up. A pixel lies less than eight rows and eight columns
  /// behind the first one, so rounding up never yields the next row.
  std::uint64_t PerWidth;
};

}

#endif
