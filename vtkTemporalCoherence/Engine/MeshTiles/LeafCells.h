// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LeafCells_h
#define TemporalCoherence_LeafCells_h

#include "MeshTiles/ActiveLeaves.h"
#include "MeshTiles/CellValues.h"
#include "MeshTiles/KernelsTileGrid.h"
#include "Scene/Frame.h"
#include "Trees/MeshTree.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// An active cell, read from its mesh.
struct ActiveCell
{
  CellNumber Number;
  std::int64_t Rank;
  MeshCell Cell;
  PointLanes Points;   ///< those of the cell
  NearlyLinear Values; ///< of a hexahedron, if all are finite
  FloatBox Box;        ///< in index space
};

/// Reads the active cells of leaves, each leaf once, for all tiles of a frame. Thread-safe.
class LeafCells
{
public:
  /// The active cells of a leaf.
  struct Leaf
  {
    std::vector<ActiveCell> Cells;
    BoxLanes Boxes; ///< around them, in index space
  };

  /// The arguments must outlive this.
  /// \throws std::bad_alloc
  LeafCells(const MeshTree& tree, const ActiveLeaves& leaves);
  ~LeafCells();
  LeafCells(const LeafCells&) = delete;
  LeafCells& operator=(const LeafCells&) = delete;

  /// The active cells of an active leaf.
  /// \param spare holds them, if there is no room to keep them
  /// \throws std::bad_alloc
  const Leaf& Of(std::int64_t leaf, Leaf& spare) const;

private:
  /// What is kept for a frame at most. Measured: the surfaces of 10 million tetrahedra take 40 MB.
  static constexpr std::int64_t MostBytes = 256 << 20;

  void Read(std::int64_t leaf, Leaf& read) const;

  const MeshTree& Tree;
  const ActiveLeaves& Leaves;
  std::unique_ptr<std::atomic<const Leaf*>[]> Kept;
  mutable std::atomic<std::int64_t> Bytes{ 0 };
};

}

#endif
