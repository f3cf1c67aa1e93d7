// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tiles/BoxLevels.h"

#include "Scene/Parallel.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t Children = MeshLattice::SizeOfBlock;

/// The children of a block.
BoxLanes LanesOf(const MeshTree& tree, std::size_t level, std::int64_t block)
{
  BoxLanes lanes = NoBoxes();
  const std::int64_t first = Children * block;
  const std::int64_t end = std::min(first + Children, tree.NumberOfBlocks(level - 1));
  for (std::int64_t child = first; child < end; ++child)
  {
    const FloatBox& box = tree.BlockBox(level - 1, child);
    lanes.Set(static_cast<std::size_t>(child - first), glm::dvec3(box.Low), glm::dvec3(box.High));
  }
  return lanes;
}

}

BoxLevels::BoxLevels(const MeshTree& tree)
{
  for (std::size_t level = 1; level < tree.NumberOfLevels(); ++level)
  {
    const std::int64_t blocks = tree.NumberOfBlocks(level);
    std::vector<BoxLanes> lanes(static_cast<std::size_t>(blocks));
    ParallelFor(blocks, 16,
      [&](std::int64_t block)
      { lanes[static_cast<std::size_t>(block)] = LanesOf(tree, level, block); });
    this->Levels.push_back(std::move(lanes));
  }
}

std::size_t BoxLevels::MemoryInBytes() const
{
  std::size_t bytes = 0;
  for (const std::vector<BoxLanes>& level : this->Levels)
  {
    bytes += level.capacity() * sizeof(BoxLanes);
  }
  return bytes;
}

}
