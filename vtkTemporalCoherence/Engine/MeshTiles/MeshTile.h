// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshTile_h
#define TemporalCoherence_MeshTile_h

#include "Mesh/CellRays.h"
#include "MeshTiles/ActiveLeaves.h"
#include "MeshTiles/KernelsBoxes.h"
#include "MeshTiles/KernelsOutlines.h"
#include "MeshTiles/LeafCells.h"
#include "MeshTiles/PreparedLeaves.h"
#include "MeshTiles/TileGrid.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Trees/MeshTree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Between which distances rays meet cells.
enum class RayLimits : std::uint8_t
{
  BeginToEnd, ///< of the ray
  None        ///< everywhere: it matters what is before the ray's beginning
};

/// The rays of a batch in the coordinates of a mesh.
inline void SetUpMeshRays(
  const RayBatch& rays, const MeshTree& tree, RayLimits limits, MeshKernels::MeshRays& inMesh)
{
  constexpr double far = 1e300;
  inMesh.Count = static_cast<std::size_t>(rays.Count);
  for (std::size_t ray = 0; ray < inMesh.Count; ++ray)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      inMesh.Origin[a][ray] = tree.Low()[static_cast<int>(a)] + tree.Scale() * rays.Origin[a][ray];
      inMesh.Direction[a][ray] = tree.Scale() * rays.Direction[a][ray];
    }
    inMesh.Begin[ray] = limits == RayLimits::None ? -far : rays.Begin[ray];
    inMesh.End[ray] = limits == RayLimits::None ? far : rays.End[ray];
  }
  inMesh.Prepare();
}

/// One bit for each ray of a batch that may meet a surface.
inline std::uint64_t RaysWithWalk(const RayBatch& rays)
{
  std::uint64_t wanted = 0;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    wanted |= static_cast<std::uint64_t>(rays.HasWalk(ray)) << ray;
  }
  return wanted;
}

/// Of the lattice of a tree.
inline double LongestAxis(const MeshTree& tree)
{
  const glm::ivec3& size = tree.Dimensions();
  return std::max({ size.x, size.y, size.z });
}

/// The rays of a tile, and the active leaves of a mesh along them.
struct MeshTile
{
  /// \throws std::bad_alloc
  MeshTile(const RayBatch& rays, const MeshTree& tree, const ActiveLeaves& leaves, RayLimits limits)
    : Rays(rays)
    , Tree(tree)
    , Grid(rays, tree)
    , Margin(ActiveLeaves::MarginOf(rays, tree))
    , MarginOfLanes(Margin + BoxLanes::Rounding * LongestAxis(tree))
  {
    SetUpMeshRays(rays, tree, limits, this->InMesh);
    leaves.Find(rays, this->Grid, this->Leaves);
  }

  const RayBatch& Rays;
  const MeshTree& Tree;
  TileGrid Grid;
  double Margin;        ///< against rounding, in index space
  double MarginOfLanes; ///< the same for BoxLanes, whose boxes are rounded
  MeshKernels::MeshRays InMesh;
  std::vector<ActiveLeaves::Leaf> Leaves; ///< from front to back
};

/// The cells of a leaf that a tile may see, from front to back, roughly.
struct CellsInOrder
{
  CellsInOrder(const LeafCells::Leaf& leaf, const TileGrid& grid)
  {
    const std::uint64_t all =
      leaf.Cells.size() < 64 ? (std::uint64_t(1) << leaf.Cells.size()) - 1 : ~std::uint64_t(0);
    std::array<double, 64> depths;
    ForEachRay(grid.IsGrid() ? BoxesWithin(grid.Planes(), leaf.Boxes) : all,
      [&](std::size_t i)
      {
        const double depth = grid.NearestDepth(leaf.Boxes.BoxAt(i));
        std::size_t at = this->Count++;
        for (; at > 0 && depths[at - 1] > depth; --at)
        {
          depths[at] = depths[at - 1];
          this->Places[at] = this->Places[at - 1];
        }
        depths[at] = depth;
        this->Places[at] = static_cast<std::uint8_t>(i);
      });
  }

  const std::uint8_t* begin() const { return this->Places.data(); }
  const std::uint8_t* end() const { return this->Places.data() + this->Count; }

  std::array<std::uint8_t, 64> Places;
  std::size_t Count = 0;
};

/// Call visit(cell, rays) for each cell of a leaf that rays may pass.
/// \return number of cells visited
template <typename Visit>
std::int64_t VisitCellsOf(const LeafCells::Leaf& leaf, const MeshTile& tile, std::uint64_t wanted,
  const RayBatch::Array<double>& limits, const Visit& visit)
{
  std::int64_t visited = 0;
  for (const std::uint8_t place : CellsInOrder(leaf, tile.Grid))
  {
    const ActiveCell& cell = leaf.Cells[place];
    const bool isHexahedron = cell.Cell.Shape == MeshCellShape::Hexahedron;
    std::uint64_t which = tile.Grid.IsGrid()
      ? wanted & tile.Grid.RaysAround(cell.Points, cell.Cell.NumberOfPoints())
      : wanted;
    // It takes longer to search a hexahedron than to find out that nothing nearer is in it.
    if (which != 0 && (isHexahedron || !tile.Grid.IsGrid()))
    {
      which = RaysThrough(tile.Rays, which, limits, leaf.Boxes.BoxAt(place), tile.MarginOfLanes);
    }
    if (which != 0)
    {
      ++visited;
      visit(cell, which);
    }
  }
  return visited;
}

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

/// Call visit(surface, cells, place in these, rays) for each cell that a surface passes and rays
/// may pass, with one bit for each of these rays; leaf by leaf, from front to back. \param wanted
/// one bit for each ray \param limits of rays: what is farther away does not matter. Visits may
/// bring them nearer \return number of cells visited \throws std::bad_alloc
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
    for (std::size_t surface = 0; ofLeaf != 0 && surface < prepared.NumberOfSurfaces(); ++surface)
    {
      const PreparedCells& cells =
        prepared.Of(leaf.Number, surface, active.CellsOf(leaf.Number), spare);
      const CellsToVisit order(cells, box, tile.Grid, ofLeaf);
      for (const std::uint8_t cell : order)
      {
        std::uint64_t which = order.RaysOf(cell);
        // It takes longer to search a hexahedron than to find out that nothing nearer is in it.
        if (!cells.IsTetrahedron(cell))
        {
          const PreparedHexahedron& hexahedron = cells.HexahedronAt(cell);
          which = RaysAcross(
            tile.Rays, which, limits, hexahedron.Box, tile.MarginOfLanes, hexahedron.Values);
        }
        else if (!order.AreSeen())
        {
          which =
            RaysThrough(tile.Rays, which, limits, cells.BoxOf(cell, tile.Tree), tile.MarginOfLanes);
        }
        if (which != 0)
        {
          ++visited;
          visit(surface, cells, cell, which);
        }
      }
    }
  }
  return visited;
}

}

#endif
