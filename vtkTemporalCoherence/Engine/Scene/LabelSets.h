// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelSets_h
#define TemporalCoherence_LabelSets_h

#include "Scene/CellBlocks.h"
#include "Scene/CellBox.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

struct Field;

/// Which labels a field has, and where: a set of labels for each leaf of cells. A label is a whole
/// number that names a part of the data. Sets are built once, never changed, and shared.
///
/// A set is a word. Each label has one of 63 bits, which several labels may share. The last bit
/// says that the leaf has more than one label.
class LabelSets
{
public:
  /// Read all samples once, in parallel.
  /// \pre field.HasCells(), and samples are whole numbers
  /// \throws std::bad_alloc
  static std::shared_ptr<const LabelSets> Make(const Field& field);

  /// The sets of a field whose samples have changed in some cells since these were made. Reads no
  /// other samples.
  /// \throws std::bad_alloc
  std::shared_ptr<const LabelSets> Updated(
    const Field& field, const std::vector<CellBox>& changed) const;

  /// All labels of the field, ascending.
  const std::vector<std::int64_t>& Labels() const { return this->All; }

  /// The bits of some labels.
  static std::uint64_t BitsOf(const std::vector<double>& labels);

  /// One bit for each leaf of a node with several labels, some of which are among the bits.
  std::uint64_t LeavesWith(std::uint64_t bits, std::int64_t node) const
  {
    const std::uint64_t* const leaves =
      &this->Leaves[static_cast<std::size_t>(node) * CellBlocks::LeavesPerNode];
    std::uint64_t found = 0;
    for (int i = 0; i < CellBlocks::LeavesPerNode; ++i)
    {
      const bool isMixed = leaves[i] >> 63 != 0 && (leaves[i] & bits) != 0;
      found |= static_cast<std::uint64_t>(isMixed) << i;
    }
    return found;
  }

private:
  void Scan(const Field& field, const std::vector<std::int64_t>& nodes);
  void FindAll();

  std::vector<std::int64_t> All;
  std::vector<std::uint64_t> Leaves;              ///< node by node
  std::vector<std::vector<std::int64_t>> OfNodes; ///< labels of each node, ascending
};

}

#endif
