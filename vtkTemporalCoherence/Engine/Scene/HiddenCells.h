// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HiddenCells_h
#define TemporalCoherence_HiddenCells_h

#include "Scene/CellBlocks.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

struct Field;

/// Flags that hide cells: one byte for each cell, and one for each sample, x fastest; null for
/// none.
struct HidingFlags
{
  const std::uint8_t* OfCells = nullptr;
  std::uint8_t CellMask = 0; ///< a cell with any of these bits is hidden
  const std::uint8_t* OfSamples = nullptr;
  std::uint8_t SampleMask = 0; ///< the cells around a sample with any of these bits are hidden
  const std::uint8_t* Shown = nullptr; ///< a cell is hidden if this is 0 at all of its samples
};

/// The hidden cells of a field: no surface is drawn in them. One word for each leaf, with the bits
/// of ActiveCells. Samples of hidden cells still serve neighbouring cells and their gradients,
/// unless they are not numbers. Built once, never changed, and shared. A field without hidden cells
/// has no such object.
class HiddenCells
{
public:
  /// Read the flags once, in parallel.
  /// \param samples of the field along each axis, at least two
  /// \return null if no cell is hidden
  /// \throws std::bad_alloc
  static std::shared_ptr<const HiddenCells> Make(
    const glm::ivec3& samples, const HidingFlags& flags);

  /// The flagged cells of a field, and its cells with a NaN sample. Reads only leaves with such
  /// samples.
  /// \param leavesWithNaN one word for each node, one bit for each leaf; empty if there are none
  /// \return null if no cell is hidden
  /// \throws std::bad_alloc
  static std::shared_ptr<const HiddenCells> WithoutNaN(
    const Field& field, const std::vector<std::uint64_t>& leavesWithNaN);

  /// One bit for each hidden cell of the leaf that holds `cell`; 0 outside of the field.
  std::uint64_t LeafAt(const glm::ivec3& cell) const
  {
    const glm::ivec3 node = cell >> CellBlocks::NodeBits;
    if (glm::any(glm::lessThan(cell, glm::ivec3(0))) ||
      glm::any(glm::greaterThanEqual(node, this->Nodes)))
    {
      return 0;
    }
    const std::int64_t place =
      node.x + static_cast<std::int64_t>(this->Nodes.x) * (node.y + this->Nodes.y * node.z);
    const glm::ivec3 leaf = (cell >> CellBlocks::LeafBits) & 3;
    return this->Words[static_cast<std::size_t>(
      place * CellBlocks::LeavesPerNode + leaf.x + 4 * leaf.y + 16 * leaf.z)];
  }

  /// True if a cell is hidden; false outside of the field.
  bool IsHidden(const glm::ivec3& cell) const
  {
    const glm::ivec3 inLeaf = cell & 3;
    return this->LeafAt(cell) >> (inLeaf.x + 4 * inLeaf.y + 16 * inLeaf.z) & 1u;
  }

  /// One bit for each cell of a leaf, set if it is hidden or shares a corner with a hidden cell.
  /// \param firstCell of the leaf
  std::uint64_t Around(const glm::ivec3& firstCell) const;

  /// How many cells are hidden.
  std::int64_t Count() const;

  std::size_t MemoryInBytes() const { return sizeof(std::uint64_t) * this->Words.capacity(); }

private:
  HiddenCells() = default;

  glm::ivec3 Nodes{ 0 };
  std::vector<std::uint64_t> Words; ///< for all leaves, node by node
};

}

#endif
