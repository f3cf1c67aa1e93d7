// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshTiles/ActiveLeaves.h"

#include "MeshTiles/KernelsBoxes.h"
#include "Scene/LayerBatch.h"
#include "Trees/MeshLattice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t Children = MeshLattice::SizeOfBlock;

/// One bit for each of the first `count` children of a block.
std::uint64_t FirstBits(std::int64_t count)
{
  return count >= Children ? ~std::uint64_t(0)
                           : (std::uint64_t(1) << std::max<std::int64_t>(count, 0)) - 1;
}

}

double ActiveLeaves::MarginOf(const RayBatch& rays, const MeshTree& tree)
{
  const glm::ivec3& size = tree.Dimensions();
  double farthest = size.x + size.y + size.z;
  for (std::size_t a = 0; a < 3; ++a)
  {
    farthest += std::abs(rays.Origin[a][0]);
  }
  return 0x1p-40 * farthest;
}

/// One bit for each active child of a block of a level above the leaves.
std::uint64_t ActiveLeaves::WordOf(std::size_t level, std::int64_t block) const
{
  if (!this->Active)
  {
    return FirstBits(this->Tree.NumberOfBlocks(level - 1) - Children * block);
  }
  const glm::ivec3 place = MeshLattice::PlaceOf(block);
  return level == 1 ? this->Active->LeavesOf(this->Active->NodeOf(ActiveCells::NodeSize * place))
                    : this->Active->LevelsAbove()[level - 2].WordOf(place);
}

void ActiveLeaves::Find(const RayBatch& rays, const TileGrid& grid, std::vector<Leaf>& leaves) const
{
  leaves.clear();
  if (this->Tree.NumberOfCells() == 0)
  {
    return;
  }
  struct Block
  {
    std::size_t Level;
    std::int64_t Number;
  };
  constexpr std::size_t mostLevels = 12;
  std::array<Block, mostLevels * Children> open;
  std::size_t count = 0;
  const double margin = MarginOf(rays, this->Tree);
  open[count++] = { this->Tree.NumberOfLevels() - 1, 0 };
  while (count > 0)
  {
    const Block block = open[--count];
    std::uint64_t word = this->WordOf(block.Level, block.Number);
    if (grid.IsGrid())
    {
      word &= BoxesWithin(grid.Planes(), this->Boxes.ChildrenOf(block.Level, block.Number));
    }
    ForEachRay(word,
      [&](std::size_t bit)
      {
        const Block child{ block.Level - 1,
          Children * block.Number + static_cast<std::int64_t>(bit) };
        const FloatBox& box = this->Tree.BlockBox(child.Level, child.Number);
        const bool mayMeet = grid.IsGrid() || RaysThrough(rays, rays.WalkEnd, box, margin) != 0;
        if (mayMeet && child.Level > 0)
        {
          open[count++] = child;
        }
        else if (mayMeet)
        {
          leaves.push_back({ grid.NearestDepth(box), child.Number });
        }
      });
  }
  std::sort(leaves.begin(), leaves.end(),
    [](const Leaf& a, const Leaf& b)
    { return a.Depth != b.Depth ? a.Depth < b.Depth : a.Number < b.Number; });
}

std::uint64_t ActiveLeaves::CellsOf(std::int64_t leaf) const
{
  if (!this->Active)
  {
    return FirstBits(this->Tree.NumberOfCells() - Children * leaf);
  }
  const glm::ivec3 cell = ActiveCells::LeafSize * MeshLattice::PlaceOf(leaf);
  return this->Active->CellsOf(this->Kind, this->Active->NodeOf(cell), cell);
}

}
