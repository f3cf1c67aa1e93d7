// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnownRanges_h
#define TemporalCoherence_KnownRanges_h

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Value ranges of a field: the smallest and largest sample in each block of cells
/// (CellBlocks). Large volumes keep it in a file, which is mapped.
struct KnownRanges
{
  /// Two samples for each leaf, node by node, and then two for each node.
  std::shared_ptr<const std::byte> Bytes;
  glm::dvec2 Finite{ 0.0 }; ///< of all finite samples; {0, 0} if there is none
  glm::dvec2 Whole{ 0.0 };  ///< of all samples that are numbers
  bool HasFinite = false;   ///< some sample is finite
  /// For each node one bit for each leaf that has NaN samples; empty if there are none.
  std::vector<std::uint64_t> LeavesWithNaN;
};

}

#endif
