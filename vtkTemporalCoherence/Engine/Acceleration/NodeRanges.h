// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_NodeRanges_h
#define TemporalCoherence_NodeRanges_h

#include "Acceleration/ValueRangePyramid.h"
#include "Scene/CellBox.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

template <typename T>
using Range = ValueRangePyramid::Range<T>;

template <typename T>
Range<T> Union(const Range<T>& a, const Range<T>& b)
{
  return { std::min(a.Min, b.Min), std::max(a.Max, b.Max) };
}

template <typename T>
bool IsFinite(const Range<T>& range)
{
  return std::isfinite(static_cast<double>(range.Min)) &&
    std::isfinite(static_cast<double>(range.Max));
}

/// The range of all samples of nodes.
template <typename T>
glm::dvec2 WholeRangeOf(const Range<T>* nodes, std::int64_t count)
{
  Range<T> all = ValueRangePyramid::Empty<T>();
  for (std::int64_t node = 0; node < count; ++node)
  {
    all.Min = std::min(all.Min, nodes[node].Min);
    all.Max = std::max(all.Max, nodes[node].Max);
  }
  return { static_cast<double>(all.Min), static_cast<double>(all.Max) };
}

/// The cells of a leaf of a node. Their size is not positive beyond the end of the field.
inline CellBox CellsOfLeaf(const Field& field, const glm::ivec3& node, int leaf)
{
  const glm::ivec3 first = CellBlocks::NodeSize * node +
    CellBlocks::LeafSize * glm::ivec3(leaf & 3, leaf >> 2 & 3, leaf >> 4);
  return { first, glm::min(field.Dimensions - 1 - first, glm::ivec3(CellBlocks::LeafSize)) };
}

/// The number of nodes in a grid of nodes.
inline std::int64_t CountOf(const glm::ivec3& nodes)
{
  return static_cast<std::int64_t>(nodes.x) * nodes.y * nodes.z;
}

/// The ranges of leaves and of nodes, to be filled.
template <typename T>
struct NodeRanges
{
  /// \param room of RangeScan::BytesFor()
  NodeRanges(std::int64_t nodes, std::byte* room)
    : OfLeaves(reinterpret_cast<Range<T>*>(room))
    , OfNodes(this->OfLeaves + nodes * ValueRangePyramid::LeavesPerNode)
  {
  }

  Range<T>* OfLeaves;
  Range<T>* OfNodes;
};

}

#endif
