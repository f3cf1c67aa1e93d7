// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Adaptive/LeafSearch.h"

namespace TemporalCoherence
{

LeafSearch::LeafSearch(const AmrBlocks& blocks, const AmrLeaves& leaves, std::size_t block)
  : Blocks(blocks)
  , Leaves(leaves)
  , Block(block)
{
  this->Last.fill(block);
}

AmrLeaf LeafSearch::LeafIn(std::size_t number, const glm::i64vec3& finest) const
{
  const AmrBlock& block = this->Blocks.Blocks[number];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (finest[axis] < block.Finest.First[axis] || finest[axis] >= block.Finest.End[axis])
    {
      return { number, -1 };
    }
  }
  const glm::i64vec3 at =
    (finest - block.Finest.First) / this->Blocks.Levels[block.Level].Ratio + block.Cells.First;
  return { number, this->Leaves.NumberOf(number, block.NumberOf(at)) };
}

AmrLeaf LeafSearch::FindLeaf(const glm::i64vec3& finest, std::size_t& last) const
{
  // Leaves do not overlap, so the first match ends the search.
  AmrLeaf leaf = this->LeafIn(last, finest);
  if (leaf.Number < 0 && last != this->Block)
  {
    leaf = this->LeafIn(this->Block, finest);
  }
  const std::vector<std::size_t>& neighbours = this->Blocks.Neighbours[this->Block];
  for (std::size_t n = 0; n < neighbours.size() && leaf.Number < 0; ++n)
  {
    leaf = this->LeafIn(neighbours[n], finest);
  }
  last = leaf.Number < 0 ? this->Block : leaf.Block;
  return leaf;
}

bool LeafSearch::FindAround(const glm::i64vec3& vertex, std::array<std::int32_t, 8>& numbers)
{
  const AmrBlock& block = this->Blocks.Blocks[this->Block];
  const glm::i64vec3 corner = vertex * this->Blocks.Levels[block.Level].Ratio;
  for (std::size_t octant = 0; octant < 8; ++octant)
  {
    const glm::i64vec3 finest(corner.x - (octant & 1u ? 0 : 1), corner.y - (octant & 2u ? 0 : 1),
      corner.z - (octant & 4u ? 0 : 1));
    const AmrLeaf leaf = this->FindLeaf(finest, this->Last[octant]);
    if (leaf.Number < 0 || leaf.Block < this->Block)
    {
      return false;
    }
    numbers[octant] = leaf.Number;
  }
  return true;
}

}
