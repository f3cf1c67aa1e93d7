// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshBandTracer_h
#define TemporalCoherence_MeshBandTracer_h

#include "Isomap/BandTracer.h"
#include "Mesh/KernelsCells.h"
#include "MeshFields/MeshBandRays.h"
#include "MeshTiles/ActiveLeaves.h"
#include "MeshTiles/MeshTile.h"
#include "MeshTiles/PreparedLeaves.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Traces rays through the cells of a mesh that a band goes through, for isomaps: which cells raise
/// what a ray has reached.
///
/// In a tetrahedron it is known what a ray reaches. In a hexahedron it may be less than the highest
/// value of the cell, so that a look-up may find no crossing there. It goes on to the next knots.
class MeshBandTracer final : public BandTracer
{
public:
  MeshBandTracer(
    const BandScene& scene, const FieldKind& kind, const MeshTree& tree, const BoxLevels& boxes);

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
  double Unit;  ///< of the band's scale, in those of differences
  double Width; ///< of the band, as a difference
  PreparedLeaves Prepared;
};

}

#endif
