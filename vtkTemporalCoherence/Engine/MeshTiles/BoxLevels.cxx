// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshTiles/BoxLevels.h"

#include "Scene/Parallel.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t Children = MeshLattice::SizeOfBlock;

/// The children of a block. \param count of blocks on the level of children
BoxLanes LanesOf(const MeshTree& tree, std::size_t level, std::int64_t block, std::int64_t count)
{
  BoxLanes lanes = NoBoxes();
  const std::int64_t first = Children * block;
  for (std::int64_t child = first; child < std::min(first + Children, count); ++child)
  {
    const FloatBox& box = tree.BlockBox(level - 1, child);
    lanes.Set(static_cast<std::size_t>(child - first), glm::dvec3(box.Low), glm::dvec3(box.High));
  }
  return lanes;
}

}

BoxLevels::BoxLevels(const MeshTree& tree)
{
  std::int64_t count = tree.NumberOfLeaves();
  for (std::size_t level = 1; level < tree.NumberOfLevels(); ++level)
  {
    const std::int64_t blocks = (count + Children - 1) / Children;
    std::vector<BoxLanes> lanes(static_cast<std::size_t>(blocks));
    ParallelFor(blocks, 16,
      [&](std::int64_t block)
      { lanes[static_cast<std::size_t>(block)] = LanesOf(tree, level, block, count); });
    this->Levels.push_back(std::move(lanes));
    count = blocks;
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
