// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsOutlines_h
#define TemporalCoherence_KernelsOutlines_h

#include "MeshTiles/CellOutlines.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// How the outlines of a leaf are seen by a tile of 8 x 8 pixels. For a point p,
///   w = Middle[0] + Row[0] . p,  column = (Middle[1] + Row[1] . p) / w,  row likewise.
/// In parallel views, nothing is divided; w orders points from front to back all the same.
struct OutlineView
{
  std::array<std::array<float, 3>, 3> Row;
  std::array<float, 3> Middle; ///< of the leaf
  bool IsPerspective;
  float Reach;  ///< farthest coordinate of the leaf in pixels: rounding errors grow with it
  float Margin; ///< pixels around a cell, against rounding
};

/// What a tile sees of the cells of a leaf.
struct SeenCells
{
  alignas(64) std::array<std::uint64_t, 64> Pixels; ///< one bit each: column + 8 row
  alignas(64) std::array<float, 64> Depth;          ///< w of the nearest corner
};

/// Find the pixels that may see a surface in each cell.
void PixelsOfCells(const OutlineView& view, const CellOutlines& cells, SeenCells& seen);

}

#endif
