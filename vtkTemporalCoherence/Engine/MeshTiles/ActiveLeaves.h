// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ActiveLeaves_h
#define TemporalCoherence_ActiveLeaves_h

#include "Acceleration/ActiveCells.h"
#include "MeshTiles/BoxLevels.h"
#include "MeshTiles/TileGrid.h"
#include "Scene/FieldKind.h"
#include "Scene/RayBatch.h"
#include "Trees/MeshTree.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Finds the active leaves of a tree that the rays of a tile may pass.
class ActiveLeaves
{
public:
  /// \param active null: all leaves and all of their cells are active
  ActiveLeaves(
    const FieldKind& kind, const MeshTree& tree, const BoxLevels& boxes, const ActiveCells* active)
    : Kind(kind)
    , Tree(tree)
    , Boxes(boxes)
    , Active(active)
    , Stamp(NewStamp())
  {
  }

  /// No other object has it.
  std::uint64_t StampOf() const { return this->Stamp; }

  struct Leaf
  {
    double Depth; ///< of the nearest point of the box: no ray meets the leaf before
    std::int64_t Number;
  };

  /// Find the leaves, in the order of Depth.
  /// \param leaves gets them
  /// \throws std::bad_alloc
  void Find(const RayBatch& rays, const TileGrid& grid, std::vector<Leaf>& leaves) const;

  /// One bit for each active cell of an active leaf.
  std::uint64_t CellsOf(std::int64_t leaf) const;

  /// How far rounding may move a ray against a box, in index space, and more.
  static double MarginOf(const RayBatch& rays, const MeshTree& tree);

private:
  struct Row;

  void FindRow(const TileGrid& grid, Row& row) const;
  static std::uint64_t NewStamp();
  static void SortLeaves(std::vector<Leaf>& leaves);
  std::uint64_t WordOf(std::size_t level, std::int64_t block) const;

  const FieldKind& Kind;
  const MeshTree& Tree;
  const BoxLevels& Boxes;
  const ActiveCells* Active;
  std::uint64_t Stamp; ///< of this and no other object
};

}

#endif
