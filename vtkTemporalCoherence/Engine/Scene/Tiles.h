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

/// The place of a pixel in its tile, row by row.
/// \param part  the pixels of the tile
/// \param width of the picture
/// \param pixel position in the picture, row by row
inline std::size_t PlaceInTile(const PixelRect& part, int width, std::int32_t pixel)
{
  // A tile has few rows: this is faster than a division.
  int x = pixel - part.First.y * width - part.First.x;
  int row = 0;
  for (; x >= width; x -= width)
  {
    ++row;
  }
  return static_cast<std::size_t>(row * part.Size.x + x);
}

/// The same for many pixels, which ascend most of the time.
class PlaceFinder
{
public:
  PlaceFinder(const PixelRect& part, int width)
    : First(part.First.y * width + part.First.x)
    , Width(width)
    , Columns(part.Size.x)
    , OfRow(this->First)
  {
  }

  std::size_t Find(std::int32_t pixel)
  {
    if (pixel < this->OfRow)
    {
      this->OfRow = this->First;
      this->Before = 0;
    }
    for (; pixel - this->OfRow >= this->Width; this->OfRow += this->Width)
    {
      this->Before += this->Columns;
    }
    return static_cast<std::size_t>(this->Before + pixel - this->OfRow);
  }

private:
  int First, Width, Columns;
  int OfRow;      ///< the first pixel of the row of the last one
  int Before = 0; ///< places in the rows before it
};

}

#endif
