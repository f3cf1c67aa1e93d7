// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellBlocks_h
#define TemporalCoherence_CellBlocks_h

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// How the cells of a field are divided into blocks: *leaves* of 4 x 4 x 4 cells, and *nodes* of
/// 4 x 4 x 4 leaves. So the cells of a leaf fit the bits of one machine word, and so do the leaves
/// of a node.
struct CellBlocks
{
  static constexpr int LeafBits = 2; ///< log2 of the cells along an edge of a leaf
  static constexpr int NodeBits = 4; ///< log2 of the cells along an edge of a node
  static constexpr int LeafSize = 1 << LeafBits;
  static constexpr int NodeSize = 1 << NodeBits;
  static constexpr int LeavesPerNode = 64;

  /// Nodes along each axis of a field of this size.
  static glm::ivec3 NodesFor(const glm::ivec3& samples)
  {
    return (samples - 1 + (NodeSize - 1)) / NodeSize;
  }
};

}

#endif
