// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BoxLevels_h
#define TemporalCoherence_BoxLevels_h

#include "Mesh/Tiles/KernelsTileGrid.h"
#include "Mesh/Tree/MeshTree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The boxes of a tree in vector layout: the 64 children of each block together.
class BoxLevels
{
public:
  /// \throws std::bad_alloc
  explicit BoxLevels(const MeshTree& tree);

  /// The children of a block of a level above the leaves, as MeshTree numbers both.
  const BoxLanes& ChildrenOf(std::size_t level, std::int64_t block) const
  {
    return this->Levels[level - 1][static_cast<std::size_t>(block)];
  }

  std::size_t MemoryInBytes() const;

private:
  std::vector<std::vector<BoxLanes>> Levels;
};

}

#endif
