// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshBandTracer_h
#define TemporalCoherence_MeshBandTracer_h

#include "Isomap/BandTracer.h"
#include "Mesh/Cells/KernelsCells.h"
#include "Mesh/Tiles/ActiveLeaves.h"
#include "Mesh/Tiles/MeshTile.h"
#include "Mesh/Tiles/PreparedLeaves.h"
#include "Mesh/Tracing/MeshBandRays.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Traces rays through the cells of a mesh with values of a band, for isomaps. Finds the cells in
/// which a ray reaches new values.
///
/// In a tetrahedron, the range of a ray's values is exact. In a hexahedron it is a bound: a look-up
/// may find no crossing there, and goes on to the next knots.
class MeshBandTracer final : public BandTracer
{
public:
  MeshBandTracer(
    const BandScene& scene, const FieldShape& shape, const MeshTree& tree, const BoxLevels& boxes);

  std::int64_t Trace(const RayBatch& rays, TileKnots& knots) const override;

private:
  bool IsSolid() const { return this->Scene.Mode == SurfaceMode::Threshold; }
  NearlyLinear FromMiddle(const PreparedHexahedron& cell) const;
  std::int64_t Visit(const PreparedCells& cells, std::int64_t leaf, const MeshTile& tile,
    std::uint64_t wanted, MeshBandRays& band) const;
  void Append(const MeshKernels::TetrahedronPoints& cell, const CellIndex& index,
    const MeshTile& tile, std::uint64_t which, MeshBandRays& band) const;
  void Append(const PreparedHexahedron& cell, const CellIndex& index, const MeshTile& tile,
    std::uint64_t which, MeshBandRays& band) const;
  static double FarthestDepth(
    const MeshTile& tile, std::uint64_t which, const RayBatch::Array<double>& limits);
  static RayBatch::Array<double> DistancesAt(const MeshTile& tile, double depth);

  BandScene Scene;
  const MeshTree& Tree;
  ActiveLeaves Leaves;
  double Unit;  ///< units of the band's scale per unit of differences
  double Width; ///< of the band, as a difference
  PreparedLeaves Prepared;
};

}

#endif
