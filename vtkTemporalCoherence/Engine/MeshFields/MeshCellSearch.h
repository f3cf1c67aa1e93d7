// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshCellSearch_h
#define TemporalCoherence_MeshCellSearch_h

#include "Mesh/CellRays.h"
#include "Mesh/KernelsCells.h"
#include "MeshFields/RecentHexahedra.h"
#include "MeshTiles/MeshDifference.h"
#include "Scene/HitOrder.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"
#include "Trace/SurfaceTracer.h"
#include "Trees/MeshTree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A surface that a ray of a tile meets in a cell.
struct MetInCell
{
  MetSurface Surface;
  std::int16_t Isovalue; ///< position in the list
  std::uint8_t Ray;
  CellNumber Cell;
};

/// Make a surface the hit of its ray if it is nearer. Of one that two cells share, the cell with
/// the lower number counts.
/// \return true if it is the hit now
bool KeepNearest(const MetInCell& met, const std::vector<double>& isovalues, HitBatch& hits);

/// Searches cells of a mesh that are known for each ray, as look-ups in isomaps do.
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

  /// As SurfaceTracer::SearchCells.
  SearchedCells Search(const RayBatch& rays, const RayCells& cells, HitBatch& hits) const;

private:
  /// One bit for each ray that meets the surface, and for each that meets it where it leaves its
  /// cell.
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
