// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshTile_h
#define TemporalCoherence_MeshTile_h

#include "Mesh/Cells/CellRays.h"
#include "Mesh/Tiles/ActiveLeaves.h"
#include "Mesh/Tiles/KernelsMeshRays.h"
#include "Mesh/Tiles/KernelsTileGrid.h"
#include "Mesh/Tiles/TileGrid.h"
#include "Mesh/Tree/MeshTree.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The range of distances in which rays meet cells.
enum class RayLimits : std::uint8_t
{
  BeginToEnd, ///< of the ray
  None        ///< unlimited: cells before the ray's beginning matter, too
};

/// The rays of a batch in the coordinates of a mesh.
inline void SetUpMeshRays(
  const RayBatch& rays, const MeshTree& tree, RayLimits limits, MeshKernels::MeshRays& inMesh)
{
  constexpr double far = 1e300;
  PutIntoMesh(rays, tree.Low(), tree.Scale(), inMesh);
  if (limits == RayLimits::None)
  {
    inMesh.Begin.fill(-far);
    inMesh.End.fill(far);
  }
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

/// Samples along the longest axis of a tree's lattice.
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
    , Stamp(leaves.StampOf())
    , Number(NewNumber())
  {
    SetUpMeshRays(rays, tree, limits, this->InMesh);
    leaves.Find(rays, this->Grid, this->Leaves);
  }

  const RayBatch& Rays;
  const MeshTree& Tree;
  TileGrid Grid;
  double Margin;        ///< against rounding, in index space
  double MarginOfLanes; ///< the margin for BoxLanes, whose boxes are rounded
  std::uint64_t Stamp;  ///< of the active leaves
  std::uint64_t Number; ///< unique among the tiles of this thread
  MeshKernels::MeshRays InMesh;
  std::vector<ActiveLeaves::Leaf> Leaves; ///< from front to back

private:
  static std::uint64_t NewNumber()
  {
    thread_local std::uint64_t last = 0;
    return ++last;
  }
};

}

#endif
