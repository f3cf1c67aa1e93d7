// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellVisits_h
#define TemporalCoherence_CellVisits_h

#include "Mesh/Tiles/ActiveLeaves.h"
#include "Mesh/Tiles/KernelsBoxes.h"
#include "Mesh/Tiles/KernelsOutlines.h"
#include "Mesh/Tiles/MeshTile.h"
#include "Mesh/Tiles/PreparedCells.h"
#include "Mesh/Tiles/PreparedLeaves.h"
#include "Mesh/Tiles/SeenStrip.h"
#include "Scene/RayBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The prepared cells of a leaf, and the pixels of a tile that see them.
struct CellsInLeaf
{
  /// \param key   of the leaf and the cells
  /// \param box   of the leaf
  /// \param which one bit for each ray that may pass the leaf
  /// \throws std::bad_alloc
  void See(const PreparedCells& cells, std::int64_t key, const FloatBox& box, const MeshTile& tile,
    std::uint64_t which)
  {
    this->Cells = &cells;
    this->Which = which;
    this->Seen.Count = 0;
    this->AreSeen = tile.Grid.IsGrid() &&
      SeenStrip::OfThread().FindPixels(tile, key, cells.Outlines, box, this->Seen);
    for (std::size_t i = 0; i < this->Seen.Count; ++i)
    {
      cells.Prefetch(this->Seen.Cell[i]);
    }
  }

  /// Call visit(place, rays) for each cell that rays may pass.
  /// \param limits as below
  /// \return number of cells visited
  template <typename Visit>
  std::int64_t VisitAll(
    const MeshTile& tile, const RayBatch::Array<double>& limits, const Visit& visit) const
  {
    std::int64_t visited = 0;
    const std::size_t count = this->AreSeen ? this->Seen.Count : this->Cells->Count();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t cell = this->AreSeen ? this->Seen.Cell[i] : i;
      const std::uint64_t which = this->AreSeen
        ? RaysReaching(tile.Rays, this->Which & this->Seen.Pixels[i], limits,
            tile.Grid.DepthUnit() * static_cast<double>(this->Seen.Depth[i]))
        : RaysThrough(tile.Rays, this->Which, limits, this->Cells->BoxOf(cell, tile.Tree),
            tile.MarginOfLanes);
      if (which != 0)
      {
        ++visited;
        visit(cell, which);
      }
    }
    return visited;
  }

  const PreparedCells* Cells;
  SeenCells Seen;
  std::uint64_t Which;
  bool AreSeen; ///< false: it is unknown which pixels see which cell
};

/// Call visit(place, rays) for each of the prepared cells of a leaf that rays may pass, with one
/// bit for each of these rays. Visits may bring limits nearer.
/// \param key    of the leaf and the cells
/// \param box    of the leaf
/// \param wanted one bit for each ray
/// \param limits of rays: cells farther away are left out
/// \return number of cells visited
/// \throws std::bad_alloc
template <typename Visit>
std::int64_t VisitCellsOf(const PreparedCells& cells, std::int64_t key, const FloatBox& box,
  const MeshTile& tile, std::uint64_t wanted, const RayBatch::Array<double>& limits,
  const Visit& visit)
{
  CellsInLeaf leaf;
  leaf.See(cells, key, box, tile, wanted);
  return leaf.VisitAll(tile, limits, visit);
}

/// Bits of the wanted rays that may pass a leaf before their limits.
inline std::uint64_t RaysInto(const ActiveLeaves::Leaf& leaf, const MeshTile& tile,
  std::uint64_t wanted, const RayBatch::Array<double>& limits)
{
  return tile.Grid.IsGrid()
    ? RaysReaching(
        tile.Rays, wanted, limits, tile.Grid.DepthUnit() * tile.Grid.ToSeenDepth(leaf.Depth))
    : RaysThrough(tile.Rays, wanted, limits, tile.Tree.LeafBox(leaf.Number), tile.Margin);
}

/// Prefetch the leaves that come soon.
HWY_INLINE void PrefetchLeaves(const MeshTile& tile, const PreparedLeaves& prepared, std::size_t i)
{
  constexpr std::size_t soon = 2, later = 4;
  if (i + later < tile.Leaves.size())
  {
    if (const PreparedCells* const cells = prepared.Known(tile.Leaves[i + later].Number, 0))
    {
      PrefetchAll(cells, 1);
    }
  }
  if (i + soon < tile.Leaves.size() && tile.Grid.IsGrid())
  {
    const std::int64_t leaf = tile.Leaves[i + soon].Number;
    if (const PreparedCells* const cells = prepared.Known(leaf, 0))
    {
      SeenStrip::OfThread().Prefetch(prepared.KeyOf(leaf, 0), cells->Outlines);
    }
  }
}

/// Call visit(surface, cells, place in these, rays) for each cell that a surface passes and rays
/// may pass, leaf by leaf, from front to back.
/// \param wanted, limits as above
/// \return number of cells visited
/// \throws std::bad_alloc
template <typename Visit>
std::int64_t VisitCells(const MeshTile& tile, const ActiveLeaves& active,
  const PreparedLeaves& prepared, std::uint64_t wanted, const RayBatch::Array<double>& limits,
  const Visit& visit)
{
  std::int64_t visited = 0;
  // Visit a leaf's cells after the next leaf was seen: meanwhile, memory brings their data.
  std::array<CellsInLeaf, 2> leaves;
  std::array<PreparedCells, 2> spare;
  std::size_t seen = 0, surfaceSeen = 0;
  const auto visitLast = [&]
  {
    const CellsInLeaf& last = leaves[(seen + 1) % 2];
    visited += seen == 0 ? 0
                         : last.VisitAll(tile, limits,
                             [&](std::size_t cell, std::uint64_t which)
                             { visit(surfaceSeen, *last.Cells, cell, which); });
  };
  for (std::size_t i = 0; i < tile.Leaves.size(); ++i)
  {
    const ActiveLeaves::Leaf& leaf = tile.Leaves[i];
    const std::uint64_t ofLeaf = RaysInto(leaf, tile, wanted, limits);
    if (ofLeaf == 0 && tile.Grid.IsGrid())
    {
      break; // Leaves farther away lie beyond the limits, too.
    }
    PrefetchLeaves(tile, prepared, i);
    for (std::size_t surface = 0; ofLeaf != 0 && surface < prepared.NumberOfIsovalues(); ++surface)
    {
      const PreparedCells& cells =
        prepared.Of(leaf.Number, surface, active.CellsOf(leaf.Number), spare[seen % 2]);
      leaves[seen % 2].See(
        cells, prepared.KeyOf(leaf.Number, surface), tile.Tree.LeafBox(leaf.Number), tile, ofLeaf);
      visitLast();
      surfaceSeen = surface;
      ++seen;
    }
  }
  visitLast();
  return visited;
}

}

#endif
