// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SeenStrip_h
#define TemporalCoherence_SeenStrip_h

#include "Mesh/Tiles/KernelsOutlines.h"
#include "Mesh/Tiles/MeshTile.h"
#include "Mesh/Tiles/PreparedCells.h"
#include "Mesh/Tree/MeshBoxes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Projections of cells for a strip of adjacent tiles in one row. A thread works through the tiles
/// of a row, and projects each cell only once.
class SeenStrip
{
public:
  /// The strip of this thread.
  static SeenStrip& OfThread()
  {
    thread_local SeenStrip strip;
    return strip;
  }

  /// Add the cells of a leaf that a tile sees.
  /// \param key of the leaf and the surface
  /// \return false if the leaf's projection is unknown
  /// \throws std::bad_alloc
  bool FindPixels(const MeshTile& tile, std::int64_t key, const CellOutlines& cells,
    const FloatBox& box, SeenCells& seen);

  /// Prefetch the outlines of a leaf that was not projected yet.
  HWY_INLINE void Prefetch(std::int64_t key, const CellOutlines& cells)
  {
    if (this->At(key).Key != key)
    {
      PrefetchAll(cells.Polygons.At.data(), cells.Polygons.At.size());
      PrefetchAll(cells.Hulls.At.data(), cells.Hulls.At.size());
    }
  }

private:
  /// The projected blocks of a leaf.
  struct Entry
  {
    std::int64_t Key = None;
    std::uint32_t First, Count;
    bool IsSeen;
  };
  static constexpr std::int64_t None = -1;

  /// With more blocks than this (5 MB), the strip is cleared.
  static constexpr std::size_t MostBlocks = 4096;
  static constexpr std::size_t LeastEntries = 256;

  void Enter(const MeshTile& tile);
  void Forget();
  void Grow();
  Entry& At(std::int64_t key);
  const Entry& See(std::int64_t key, const CellOutlines& cells, const FloatBox& box);

  std::uint64_t Stamp = 0; ///< of the active leaves
  std::uint64_t Tile = 0;  ///< the number of the last tile
  TileGrid Grid;           ///< of the first tile
  double Column = 0.0;     ///< first column of the last tile, in the grid
  std::vector<Entry> Entries = std::vector<Entry>(
    LeastEntries); ///< a table by the key, a power of two; at most half are in use
  std::size_t Used = 0;
  std::vector<SeenBlock> Blocks;
};

}

#endif
