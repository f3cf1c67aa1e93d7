// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LeafSearch_h
#define TemporalCoherence_LeafSearch_h

#include "Adaptive/AmrLeaves.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// A leaf, by its block and its number.
struct AmrLeaf
{
  std::size_t Block;
  std::int32_t Number; ///< -1: there is none
};

/// Finds leaves around vertices of a block. Remembers where it found the last ones.
class LeafSearch
{
public:
  LeafSearch(const AmrBlocks& blocks, const AmrLeaves& leaves, std::size_t block);

  /// Find the leaves in the eight octants around a vertex of the block's level. The leaf towards
  /// (x, y, z) has the position x + 2 y + 4 z.
  /// \return false if an octant has no leaf, or the leaf of an earlier block
  bool FindAround(const glm::i64vec3& vertex, std::array<std::int32_t, 8>& numbers);

private:
  AmrLeaf LeafIn(std::size_t block, const glm::i64vec3& finest) const;
  AmrLeaf FindLeaf(const glm::i64vec3& finest, std::size_t& last) const;

  const AmrBlocks& Blocks;
  const AmrLeaves& Leaves;
  std::size_t Block;
  std::array<std::size_t, 8> Last; ///< for each octant
};

}

#endif
