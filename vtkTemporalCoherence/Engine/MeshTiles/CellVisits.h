// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellVisits_h
#define TemporalCoherence_CellVisits_h

#include "MeshTiles/ActiveLeaves.h"
#include "MeshTiles/KernelsBoxes.h"
#include "MeshTiles/KernelsOutlines.h"
#include "MeshTiles/MeshTile.h"
#include "MeshTiles/PreparedCells.h"
#include "MeshTiles/PreparedLeaves.h"
#include "MeshTiles/SeenStrip.h"
#include "Scene/RayBatch.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Call visit(place, rays) for each of the prepared cells of a leaf that rays may pass, with one
/// bit for each of these rays. Visits may bring limits nearer.
/// \param key    of the leaf and the cells
/// \param box    of the leaf
/// \param wanted one bit for each ray
/// \param limits of rays: what is farther away does not matter
/// \return number of cells visited
/// \throws std::bad_alloc
template <typename Visit>
std::int64_t VisitCellsOf(const PreparedCells& cells, std::int64_t key, const FloatBox& box,
  const MeshTile& tile, std::uint64_t wanted, const RayBatch::Array<double>& limits,
  const Visit& visit)
{
  std::int64_t visited = 0;
  const auto visitIfAny = [&](std::size_t cell, std::uint64_t which)
  {
    if (which != 0)
    {
      ++visited;
      visit(cell, which);
    }
  };
  SeenCells seen;
  if (tile.Grid.IsGrid() && SeenStrip::OfThread().FindPixels(tile, key, cells.Outlines, box, seen))
  {
    for (std::size_t i = 0; i < seen.Count; ++i)
    {
      visitIfAny(seen.Cell[i],
        RaysReaching(
          tile.Rays, wanted & seen.Pixels[i], limits, static_cast<double>(seen.Depth[i])));
    }
    return visited;
  }
  for (std::size_t cell = 0; cell < cells.Count(); ++cell)
  {
    visitIfAny(cell,
      RaysThrough(tile.Rays, wanted, limits, cells.BoxOf(cell, tile.Tree), tile.MarginOfLanes));
  }
  return visited;
}

/// Of some rays, those that may pass a leaf before their limits.
inline std::uint64_t RaysInto(const ActiveLeaves::Leaf& leaf, const MeshTile& tile,
  std::uint64_t wanted, const RayBatch::Array<double>& limits)
{
  return tile.Grid.IsGrid()
    ? RaysReaching(tile.Rays, wanted, limits, tile.Grid.ToSeenDepth(leaf.Depth, tile.Margin))
    : RaysThrough(tile.Rays, wanted, limits, tile.Tree.LeafBox(leaf.Number), tile.Margin);
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
  PreparedCells spare;
  const std::size_t surfaces = prepared.NumberOfIsovalues();
  for (const ActiveLeaves::Leaf& leaf : tile.Leaves)
  {
    const std::uint64_t ofLeaf = RaysInto(leaf, tile, wanted, limits);
    if (ofLeaf == 0)
    {
      if (tile.Grid.IsGrid())
      {
        break; // Leaves farther away are not nearer than limits, either.
      }
      continue;
    }
    for (std::size_t surface = 0; surface < surfaces; ++surface)
    {
      const PreparedCells& cells =
        prepared.Of(leaf.Number, surface, active.CellsOf(leaf.Number), spare);
      const auto key =
        leaf.Number * static_cast<std::int64_t>(surfaces) + static_cast<std::int64_t>(surface);
      visited += VisitCellsOf(cells, key, tile.Tree.LeafBox(leaf.Number), tile, ofLeaf, limits,
        [&](std::size_t cell, std::uint64_t which) { visit(surface, cells, cell, which); });
    }
  }
  return visited;
}

}

#endif
