// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SeenStrip_h
#define TemporalCoherence_SeenStrip_h

#include "MeshTiles/KernelsOutlines.h"
#include "MeshTiles/MeshTile.h"
#include "MeshTiles/PreparedCells.h"
#include "Trees/MeshBoxes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Cells as a strip of tiles sees them: tiles of one row, one beside the other. A thread goes from
/// tile to tile in a row, and has to see each cell only once.
class SeenStrip
{
public:
  /// That of this thread.
  static SeenStrip& OfThread()
  {
    thread_local SeenStrip strip;
    return strip;
  }

  /// Add the cells of a leaf that a tile sees.
  /// \param key of the leaf and the surface
  /// \return false if it is not known how the tile sees the leaf
  /// \throws std::bad_alloc
  bool FindPixels(const MeshTile& tile, std::int64_t key, const CellOutlines& cells,
    const FloatBox& box, SeenCells& seen);

  /// Ask for the outlines of a leaf that will be seen.
  HWY_INLINE void Prefetch(std::int64_t key, const CellOutlines& cells)
  {
    if (this->At(key).Key != key)
    {
      PrefetchAll(cells.Polygons.At.data(), cells.Polygons.At.size());
      PrefetchAll(cells.Hulls.At.data(), cells.Hulls.At.size());
    }
  }

private:
  /// The blocks of a leaf.
  struct Entry
  {
    std::int64_t Key = None;
    std::uint32_t First, Count;
    bool IsSeen;
  };
  static constexpr std::int64_t None = -1;

  /// All is forgotten when there are so many blocks: 5 MB.
  static constexpr std::size_t MostBlocks = 4096;
  static constexpr std::size_t LeastEntries = 256;

  void Enter(const MeshTile& tile);
  void Forget();
  void Grow();
  Entry& At(std::int64_t key);
  const Entry& See(std::int64_t key, const CellOutlines& cells, const FloatBox& box);

  std::uint64_t Stamp = 0; ///< of the active leaves
  std::uint64_t Tile = 0;  ///< the number of the last one
  TileGrid Grid;           ///< of the first tile
  double Column = 0.0;     ///< the first one of the last tile, in the grid
  std::vector<Entry> Entries = std::vector<Entry>(
    LeastEntries); ///< a table by the key, a power of two; at most half are in use
  std::size_t Used = 0;
  std::vector<SeenBlock> Blocks;
};

}

#endif
