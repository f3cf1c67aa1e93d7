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
#include "Scene/RayBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The cells of a leaf that pixels of a tile may see: tetrahedra, then hexahedra from front to
/// back, roughly, as it takes long to search them.
class CellsToVisit
{
public:
  /// \param wanted one bit for each ray
  CellsToVisit(
    const PreparedCells& cells, const FloatBox& box, const TileGrid& grid, std::uint64_t wanted)
  {
    OutlineView view;
    this->IsSeen = grid.See(box, view);
    if (this->IsSeen)
    {
      PixelsOfCells(view, cells.Outlines, this->Seen);
    }
    for (std::size_t cell = 0; cell < cells.Count(); ++cell)
    {
      this->Seen.Pixels[cell] =
        wanted & (this->IsSeen ? this->Seen.Pixels[cell] : ~std::uint64_t(0));
      if (this->Seen.Pixels[cell] != 0)
      {
        this->Append(cell, this->IsSeen && !cells.IsTetrahedron(cell));
      }
    }
  }

  const std::uint8_t* begin() const { return this->Order.data(); }
  const std::uint8_t* end() const { return this->Order.data() + this->Count; }

  /// One bit for each ray that may meet a cell.
  std::uint64_t RaysOf(std::size_t cell) const { return this->Seen.Pixels[cell]; }

  /// False: nothing is known of the rays but that they may pass the leaf.
  bool AreSeen() const { return this->IsSeen; }

private:
  void Append(std::size_t cell, bool isSorted)
  {
    std::size_t at = this->Count++;
    for (; isSorted && at > 0 && this->Seen.Depth[this->Order[at - 1]] > this->Seen.Depth[cell];
         --at)
    {
      this->Order[at] = this->Order[at - 1];
    }
    this->Order[at] = static_cast<std::uint8_t>(cell);
  }

  bool IsSeen;
  SeenCells Seen;
  std::array<std::uint8_t, 64> Order;
  std::size_t Count = 0;
};

/// Call visit(place, rays) for each of the prepared cells of a leaf that rays may pass, with one
/// bit for each of these rays. Visits may bring limits nearer.
/// \param box    of the leaf
/// \param wanted one bit for each ray
/// \param limits of rays: what is farther away does not matter
/// \return number of cells visited
template <typename Visit>
std::int64_t VisitCellsOf(const PreparedCells& cells, const FloatBox& box, const MeshTile& tile,
  std::uint64_t wanted, const RayBatch::Array<double>& limits, const Visit& visit)
{
  std::int64_t visited = 0;
  const CellsToVisit order(cells, box, tile.Grid, wanted);
  for (const std::uint8_t cell : order)
  {
    std::uint64_t which = order.RaysOf(cell);
    // It takes longer to search a hexahedron than to find out that nothing nearer is in it.
    if (!cells.IsTetrahedron(cell) && cells.Purpose != CellPurpose::Bands)
    {
      const PreparedHexahedron& hexahedron = cells.HexahedronAt(cell);
      which =
        RaysAcross(tile.Rays, which, limits, hexahedron.Box, tile.MarginOfLanes, hexahedron.Values);
    }
    else if (!order.AreSeen() || !cells.IsTetrahedron(cell))
    {
      which =
        RaysThrough(tile.Rays, which, limits, cells.BoxOf(cell, tile.Tree), tile.MarginOfLanes);
    }
    if (which != 0)
    {
      ++visited;
      visit(cell, which);
    }
  }
  return visited;
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
  for (const ActiveLeaves::Leaf& leaf : tile.Leaves)
  {
    const FloatBox& box = tile.Tree.LeafBox(leaf.Number);
    const std::uint64_t ofLeaf = RaysThrough(tile.Rays, wanted, limits, box, tile.Margin);
    for (std::size_t surface = 0; ofLeaf != 0 && surface < prepared.NumberOfIsovalues(); ++surface)
    {
      const PreparedCells& cells =
        prepared.Of(leaf.Number, surface, active.CellsOf(leaf.Number), spare);
      visited += VisitCellsOf(cells, box, tile, ofLeaf, limits,
        [&](std::size_t cell, std::uint64_t which) { visit(surface, cells, cell, which); });
    }
  }
  return visited;
}

}

#endif
