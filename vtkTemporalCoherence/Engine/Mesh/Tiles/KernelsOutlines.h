// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsOutlines_h
#define TemporalCoherence_KernelsOutlines_h

#include "Mesh/Tiles/CellOutlines.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Projects the outlines of a leaf to a tile of 8 x 8 pixels, or to a strip of such tiles. For a
/// point p,
///   w = Middle[0] + Row[0] . p,  column = (Middle[1] + Row[1] . p) / w,  row likewise.
/// Parallel views skip the division; w still orders points from front to back.
struct OutlineView
{
  std::array<std::array<float, 3>, 3> Row;
  std::array<float, 3> Middle; ///< of the leaf
  bool IsPerspective;
  float Reach;      ///< farthest coordinate of the leaf in pixels: rounding errors grow with it
  float DepthReach; ///< the reach along w
  float Margin;     ///< pixels around a cell, against rounding
};

/// Projections of sixteen cells of a leaf.
struct alignas(64) SeenBlock
{
  static constexpr std::size_t Size = 16;
  using Lanes = std::array<float, Size>;

  Lanes LowX, HighX, LowY, HighY; ///< bounding rectangle of a cell's outline
  Lanes Depth;                    ///< w of the nearest point, or less

  /// Polygons: A, B and C of the four edges, with A column + B row + C not negative inside. Hulls:
  /// bounds of their pixels along 16 directions (PixelsUpTo).
  static constexpr std::size_t MostSides = 16;
  std::array<Lanes, MostSides> Sides;
  bool IsOfPolygons;
  std::size_t First, Count; ///< cells
};

/// The cells of a leaf that a tile sees, from front to back, roughly.
struct SeenCells
{
  std::size_t Count = 0;
  std::array<std::uint8_t, 64> Cell;
  std::array<std::uint64_t, 64> Pixels; ///< may see a surface there: bits column + 8 row
  std::array<float, 64> Depth;          ///< w of the nearest point, or less

  void Append(std::size_t cell, std::uint64_t pixels, float depth)
  {
    std::size_t at = this->Count++;
    for (; at > 0 && this->Depth[at - 1] > depth; --at)
    {
      this->Cell[at] = this->Cell[at - 1];
      this->Pixels[at] = this->Pixels[at - 1];
      this->Depth[at] = this->Depth[at - 1];
    }
    this->Cell[at] = static_cast<std::uint8_t>(cell);
    this->Pixels[at] = pixels;
    this->Depth[at] = depth;
  }
};

/// Project the cells of a leaf.
/// \param blocks are appended
/// \throws std::bad_alloc
void SeeCells(const OutlineView& view, const CellOutlines& cells, std::vector<SeenBlock>& blocks);

/// Find the pixels of a tile that may see a surface in cells.
/// \param column first column of the tile, in the view of the blocks
/// \param seen   cells are added
void PixelsOfCells(const SeenBlock* blocks, std::size_t count, float column, SeenCells& seen);

}

#endif
