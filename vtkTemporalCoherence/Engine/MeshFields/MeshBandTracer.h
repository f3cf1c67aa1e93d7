// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshBandTracer_h
#define TemporalCoherence_MeshBandTracer_h

#include "Isomap/BandTracer.h"
#include "MeshFields/ActiveLeaves.h"
#include "MeshFields/MeshTile.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Traces rays through the cells of a mesh that a band goes through, for isomaps: which cells raise
/// what a ray has reached.
///
/// In a tetrahedron it is known what a ray reaches. In a hexahedron it may be less than the highest
/// value of the cell, so that a look-up may find no crossing there. Such a ray is traced.
class MeshBandTracer final : public BandTracer
{
public:
  MeshBandTracer(const BandScene& scene, const FieldKind& kind, const MeshTree& tree)
    : Scene(scene)
    , Tree(tree)
    , Leaves(kind, tree, scene.Active)
  {
  }

  std::int64_t Trace(const RayBatch& rays, TileKnots& knots) const override;

private:
  /// A ray in a cell: differences from the band's lowest isovalue.
  struct Passage
  {
    double In;          ///< where the ray enters the cell
    double AtIn, AtOut; ///< where it enters, or begins in the cell, and leaves
    double Low, High;   ///< bounds in between
    bool IsFinite;      ///< all values of the cell are
    bool IsExact;       ///< values between are known: the cell is a tetrahedron
    std::uint8_t Ray;
    CellIndex Place; ///< of the cell in the lattice
  };

  std::int64_t Find(const RayBatch& rays, std::vector<Passage>& passages) const;
  void Append(const MeshCell& cell, CellNumber number, const glm::ivec3& place,
    const MeshTile& tile, std::uint64_t which, std::vector<Passage>& passages) const;

  BandScene Scene;
  const MeshTree& Tree;
  ActiveLeaves Leaves;
};

}

#endif
