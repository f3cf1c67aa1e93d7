// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshTile_h
#define TemporalCoherence_MeshTile_h

#include "Mesh/CellRays.h"
#include "MeshFields/ActiveLeaves.h"
#include "MeshFields/KernelsBoxes.h"
#include "MeshFields/LeafCells.h"
#include "MeshFields/TileGrid.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Trees/MeshTree.h"

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

/// The rays of a tile, and the active leaves of a mesh along them.
struct MeshTile
{
  /// \throws std::bad_alloc
  MeshTile(const RayBatch& rays, const MeshTree& tree, const ActiveLeaves& leaves, RayLimits limits)
    : Rays(rays)
    , Grid(rays, tree)
    , Margin(ActiveLeaves::MarginOf(rays, tree))
  {
    SetUpMeshRays(rays, tree, limits, this->InMesh);
    leaves.Find(rays, this->Grid, this->Leaves);
  }

  const RayBatch& Rays;
  TileGrid Grid;
  double Margin; ///< against rounding, in index space
  MeshKernels::MeshRays InMesh;
  std::vector<ActiveLeaves::Leaf> Leaves; ///< from front to back
};

/// Call visit(cell, rays) for each cell of a leaf that rays may pass.
/// \return number of cells visited
template <typename Visit>
std::int64_t VisitCellsOf(
  const LeafCells::Leaf& leaf, const TileGrid& grid, std::uint64_t wanted, const Visit& visit)
{
  std::int64_t visited = 0;
  const auto visitCell = [&](const ActiveCell& cell, std::uint64_t which)
  {
    if (which != 0)
    {
      ++visited;
      visit(cell, which);
    }
  };
  if (!grid.IsGrid())
  {
    for (const ActiveCell& cell : leaf.Cells)
    {
      visitCell(cell, wanted);
    }
    return visited;
  }
  ForEachRay(BoxesWithin(grid.Planes(), leaf.Boxes),
    [&](std::size_t i)
    {
      const ActiveCell& cell = leaf.Cells[i];
      visitCell(cell, wanted & grid.RaysAround(cell.Points, cell.Cell.NumberOfPoints()));
    });
  return visited;
}

/// Call visit(cell, rays) for each active cell of a tile that rays may pass, leaf by leaf from
/// front to back, with one bit for each of these rays. \param wanted one bit for each ray \param
/// limits of rays: what is farther away does not matter. Visits may bring them nearer \return
/// number of cells visited \throws std::bad_alloc
template <typename Visit>
std::int64_t VisitCells(const MeshTile& tile, const MeshTree& tree, const LeafCells& cells,
  std::uint64_t wanted, const RayBatch::Array<double>& limits, const Visit& visit)
{
  std::int64_t visited = 0;
  LeafCells::Leaf spare;
  for (const ActiveLeaves::Leaf& leaf : tile.Leaves)
  {
    const std::uint64_t ofLeaf =
      RaysThrough(tile.Rays, limits, tree.LeafBox(leaf.Number), tile.Margin) & wanted;
    if (ofLeaf != 0)
    {
      visited += VisitCellsOf(cells.Of(leaf.Number, spare), tile.Grid, ofLeaf, visit);
    }
  }
  return visited;
}

}

#endif
