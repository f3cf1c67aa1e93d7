// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_AmrLeaves_h
#define TemporalCoherence_AmrLeaves_h

#include "Shapes/AmrBlocks.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A leaf: a cell that is not refined, not hidden, and not already in an earlier block.
struct AmrLeaf
{
  std::size_t Block;
  std::int32_t Number; ///< -1: there is none
};

/// The leaves of an adaptive grid, numbered. They do not overlap.
class AmrLeaves
{
public:
  /// \return false if there are too many to be numbered
  /// \throws std::bad_alloc
  bool Find(const AmrBlocks& blocks);

  std::int32_t Count() const { return this->Total; }

  /// The number of a cell of a block; -1 if it is no leaf.
  std::int32_t NumberOf(std::size_t block, std::int64_t cell) const
  {
    return this->Numbers[block][static_cast<std::size_t>(cell)];
  }

  /// The numbers of all cells of a block.
  const std::int32_t* NumbersOf(std::size_t block) const { return this->Numbers[block].data(); }

private:
  std::vector<std::vector<std::int32_t>> Numbers;
  std::int32_t Total = 0;
};

/// Finds leaves around vertices of a block. Remembers where it found the last ones.
class LeafSearch
{
public:
  LeafSearch(const AmrBlocks& blocks, const AmrLeaves& leaves, std::size_t block);

  /// The leaves that fill the eight octants around a vertex of the block's level; the one towards
  /// (x, y, z) at x + 2 y + 4 z.
  /// \return false if an octant has none, or one of a block before this one
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
