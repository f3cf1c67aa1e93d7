// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tiles/SeenStrip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace TemporalCoherence
{

void SeenStrip::Enter(const MeshTile& tile)
{
  // Farther away, columns are less exact.
  constexpr double farthest = 128.0;
  this->Tile = tile.Number;
  const bool isBeside = this->Stamp == tile.Stamp && tile.Grid.IsGrid() && this->Grid.IsGrid() &&
    this->Grid.HasBeside(tile.Rays, this->Column) && std::abs(this->Column) <= farthest;
  if (!isBeside)
  {
    this->Forget();
    this->Stamp = tile.Stamp;
    this->Grid = tile.Grid;
    this->Column = 0.0;
  }
}

void SeenStrip::Forget()
{
  if (this->Used > 0)
  {
    std::fill(this->Entries.begin(), this->Entries.end(), Entry());
  }
  this->Used = 0;
  this->Blocks.clear();
}

/// The entry of a key, or the free entry where it belongs.
SeenStrip::Entry& SeenStrip::At(std::int64_t key)
{
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15u;
  const std::size_t last = this->Entries.size() - 1;
  std::size_t at = static_cast<std::uint64_t>(key) * factor >> 32 & last;
  while (this->Entries[at].Key != key && this->Entries[at].Key != None)
  {
    at = (at + 1) & last;
  }
  return this->Entries[at];
}

void SeenStrip::Grow()
{
  std::vector<Entry> old(2 * this->Entries.size());
  std::swap(old, this->Entries);
  for (const Entry& entry : old)
  {
    if (entry.Key != None)
    {
      this->At(entry.Key) = entry;
    }
  }
}

const SeenStrip::Entry& SeenStrip::See(
  std::int64_t key, const CellOutlines& cells, const FloatBox& box)
{
  const Entry& known = this->At(key);
  if (known.Key == key)
  {
    return known;
  }
  if (this->Blocks.size() > MostBlocks)
  {
    this->Forget();
  }
  if (2 * this->Used >= this->Entries.size())
  {
    this->Grow();
  }
  Entry& entry = this->At(key);
  const std::size_t first = this->Blocks.size();
  OutlineView view;
  entry.IsSeen = this->Grid.See(box, view);
  if (entry.IsSeen)
  {
    SeeCells(view, cells, this->Blocks);
  }
  entry.First = static_cast<std::uint32_t>(first);
  entry.Count = static_cast<std::uint32_t>(this->Blocks.size() - first);
  entry.Key = key;
  ++this->Used;
  return entry;
}

bool SeenStrip::FindPixels(const MeshTile& tile, std::int64_t key, const CellOutlines& cells,
  const FloatBox& box, SeenCells& seen)
{
  if (this->Tile != tile.Number)
  {
    this->Enter(tile);
  }
  const Entry& entry = this->See(key, cells, box);
  if (entry.IsSeen)
  {
    PixelsOfCells(
      this->Blocks.data() + entry.First, entry.Count, static_cast<float>(this->Column), seen);
  }
  return entry.IsSeen;
}

}
