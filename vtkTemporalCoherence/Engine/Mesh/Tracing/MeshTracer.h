// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshTracer_h
#define TemporalCoherence_MeshTracer_h

#include "Lattice/SurfaceTracer.h"
#include "Mesh/Tiles/ActiveLeaves.h"
#include "Mesh/Tiles/MeshTile.h"
#include "Mesh/Tiles/PreparedLeaves.h"
#include "Mesh/Tracing/MeshCellSearch.h"
#include "Mesh/Tracing/RecentHexahedra.h"

#include <vtkSMPThreadLocal.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Finds surfaces in a mesh. A tile of rays goes from leaf to leaf, and each active cell is
/// searched for all rays that may pass it.
///
/// A hit depends only on the ray and the cell (KernelsCells.h). HitOrder, then the cell's number,
/// order surfaces at one distance. So the order of cells does not matter, and all routes find the
/// same bits.
class MeshTracer final : public SurfaceTracer
{
public:
  /// \param prepared the cells of the scene's surfaces
  MeshTracer(const TraceScene& scene, const FieldShape& shape, const MeshTree& tree,
    const BoxLevels& boxes, std::shared_ptr<const PreparedLeaves> prepared);

  void Trace(const RayBatch& rays, HitBatch& hits) const override;
  void FindNext(const RayBatch& rays, HitBatch& hits) const override;
  void FindLayers(const RayBatch& rays, LayerBatch& layers) const override;
  bool FindsLayersTogether(const RayBatch&) const override { return true; }
  SearchedCells SearchCells(
    const RayBatch& rays, const RayCells& cells, HitBatch& hits) const override;

private:
  template <typename Take>
  void Search(std::size_t surface, const PreparedCells& cells, std::size_t at, const MeshTile& tile,
    std::uint64_t which, const Take& take) const;
  template <typename Take>
  void TakeCrossings(std::size_t surface, CellNumber number, const MeshKernels::Crossings& found,
    const Take& take) const;
  template <typename Take>
  void TakeSolids(std::size_t surface, CellNumber number, const MeshCell& cell,
    const MeshKernels::CellDifferences& differences, const RayBatch& rays,
    const MeshKernels::MeshRays& inMesh, std::uint64_t which, const Take& take) const;
  bool IsSolid() const { return this->Isosurfaces.Mode == SurfaceMode::Threshold; }
  RayLimits LimitsOfRays() const
  {
    return this->IsSolid() ? RayLimits::None : RayLimits::BeginToEnd;
  }

  std::vector<MetInCell> FindAll(
    const RayBatch& rays, std::uint64_t wanted, std::int64_t& cellsRead) const;
  void FindCrossings(const MeshTile& tile, std::uint64_t wanted, std::int64_t& cellsRead,
    std::vector<MetInCell>& all) const;
  void FindSolids(const MeshTile& tile, std::uint64_t wanted, std::int64_t& cellsRead,
    std::vector<MetInCell>& all) const;
  double IsovalueOf(std::size_t surface) const { return this->Isosurfaces.Isovalues[surface]; }

  Surfaces Isosurfaces;
  const MeshTree& Tree;
  ActiveLeaves Leaves;
  std::shared_ptr<const PreparedLeaves> Prepared;
  mutable vtkSMPThreadLocal<std::shared_ptr<RecentHexahedra>>
    Recent; ///< hexahedra that SearchCells searched last
};

}

#endif
