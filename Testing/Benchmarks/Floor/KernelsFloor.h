// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_KernelsFloor_h
#define Benchmarks_KernelsFloor_h

#include <array>
#include <cstddef>
#include <cstdint>

/// The least work that a picture takes: somebody knows the cell of every hit, and what is left is
/// to read its samples, find the crossing and the gradient, shade, and write colour and depth. In
/// single precision, without a thought for rounding. No picture is made this way: it tells how near
/// to it frames are.
namespace FloorKernel
{

constexpr std::size_t TilePixels = 64;

template <typename Value>
using Vector = std::array<Value, 3>;

/// A tile of 8 x 8 pixels, row by row.
struct Tile
{
  int FirstX, FirstY;
  std::uint64_t Hits; ///< one bit for each pixel
  /// The cell of each hit, moved away from the boundary of the volume where that has no samples for
  /// central differences.
  Vector<std::array<std::int32_t, TilePixels>> Cell;
};

/// What tiles are drawn of.
struct Picture
{
  const void* Samples;
  std::int32_t StrideY, StrideZ; ///< in samples; those along x are adjacent
  float Isovalue;
  /// Rays in index space. Directions are linear in the pixels, and of any length.
  Vector<float> Origin, Direction, DirectionX, DirectionY;
  Vector<float> Color; ///< RGB in 0 .. 1
  float Ambient, Diffuse, Specular;
  int Width; ///< of the planes; they are filled tile by tile, so that width and height are
             ///< multiples of 8
  float* Depth;
  std::uint32_t* Colors; ///< RGBA
};

/// Draw a tile, of hits or of none: a root of the cubic along each ray in its cell, central
/// differences, a headlight.
void DrawTile(const Picture& picture, const Tile& tile, std::uint8_t sample);
void DrawTile(const Picture& picture, const Tile& tile, std::int16_t sample);
void DrawTile(const Picture& picture, const Tile& tile, float sample);

}

#endif
