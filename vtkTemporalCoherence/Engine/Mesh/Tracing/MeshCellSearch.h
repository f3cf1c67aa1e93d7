// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshCellSearch_h
#define TemporalCoherence_MeshCellSearch_h

#include "Lattice/SurfaceTracer.h"
#include "Mesh/Cells/CellRays.h"
#include "Mesh/Cells/KernelsCells.h"
#include "Mesh/Tiles/MeshDifference.h"
#include "Mesh/Tracing/RecentHexahedra.h"
#include "Mesh/Tree/MeshTree.h"
#include "Scene/HitOrder.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A surface that a ray of a tile meets in a cell.
struct MetInCell
{
  MetSurface Surface;
  SurfaceIndex Isovalue; ///< position in the list
  std::uint8_t Ray;
  CellNumber Cell;
};

/// Make a surface the hit of its ray if it is nearer. If two cells share the surface, the lower
/// cell number counts.
/// \return true if the surface is the hit now
bool KeepNearest(const MetInCell& met, const std::vector<double>& isovalues, HitBatch& hits);

/// Searches a given cell of a mesh for each ray, for look-ups in isomaps.
class MeshCellSearch
{
public:
  /// The arguments must outlive this.
  /// \param differences from each isovalue
  /// \param recent      of this thread, for these surfaces
  MeshCellSearch(const Surfaces& surfaces, const MeshTree& tree,
    const std::vector<MeshDifference>& differences, RecentHexahedra& recent)
    : Isosurfaces(surfaces)
    , Tree(tree)
    , Differences(differences)
    , Recent(recent)
  {
  }

  /// Search only the given cells; implements SurfaceTracer::SearchCells.
  SearchedCells Search(const RayBatch& rays, const RayCells& cells, HitBatch& hits) const;

private:
  /// Bits of the rays that meet the surface, and of rays that meet it at the exit from their cell.
  struct FoundInCells
  {
    std::uint64_t Met = 0, AtEnds = 0;
  };
  struct KnownCells;
  struct RaysInOrder;
  struct ReadTetrahedra;
  FoundInCells SearchCrossings(
    const KnownCells& known, std::size_t surface, const RayBatch& rays, HitBatch& hits) const;
  FoundInCells SearchTetrahedra(const ReadTetrahedra& cells, std::size_t surface,
    const MeshKernels::MeshRays& inMesh, HitBatch& hits) const;
  FoundInCells SearchHexahedra(const KnownCells& known, std::size_t surface,
    const MeshKernels::MeshRays& inMesh, HitBatch& hits) const;
  FoundInCells SearchSolid(
    const KnownCells& known, std::size_t surface, const RayBatch& rays, HitBatch& hits) const;

  const Surfaces& Isosurfaces;
  const MeshTree& Tree;
  const std::vector<MeshDifference>& Differences;
  RecentHexahedra& Recent;
};

}

#endif
