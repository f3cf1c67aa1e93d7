// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ActiveLeaves_h
#define TemporalCoherence_ActiveLeaves_h

#include "Acceleration/ActiveCells.h"
#include "Mesh/Tiles/BoxLevels.h"
#include "Mesh/Tiles/TileGrid.h"
#include "Mesh/Tree/MeshTree.h"
#include "Scene/FieldShape.h"
#include "Scene/RayBatch.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Finds the active leaves of a tree that the rays of a tile may pass.
class ActiveLeaves
{
public:
  /// \param active null: all leaves and all of their cells are active
  ActiveLeaves(const FieldShape& shape, const MeshTree& tree, const BoxLevels& boxes,
    const ActiveCells* active)
    : Shape(shape)
    , Tree(tree)
    , Boxes(boxes)
    , Active(active)
    , Stamp(NewStamp())
  {
  }

  /// Unique for each object.
  std::uint64_t StampOf() const { return this->Stamp; }

  struct Leaf
  {
    double Depth; ///< of the nearest point of the box: no ray meets the leaf before
    std::int64_t Number;
  };

  /// Find the leaves that the rays may pass, in the order of Depth.
  /// \param leaves result
  /// \throws std::bad_alloc
  void Find(const RayBatch& rays, const TileGrid& grid, std::vector<Leaf>& leaves) const;

  /// One bit for each active cell of an active leaf.
  std::uint64_t CellsOf(std::int64_t leaf) const;

  /// Upper bound of how far rounding moves a ray against a box, in index space.
  static double MarginOf(const RayBatch& rays, const MeshTree& tree);

private:
  struct Row;

  void FindRow(const TileGrid& grid, Row& row) const;
  static std::uint64_t NewStamp();
  static void SortLeaves(std::vector<Leaf>& leaves);
  std::uint64_t WordOf(std::size_t level, std::int64_t block) const;

  const FieldShape& Shape;
  const MeshTree& Tree;
  const BoxLevels& Boxes;
  const ActiveCells* Active;
  std::uint64_t Stamp; ///< unique for each object
};

}

#endif
