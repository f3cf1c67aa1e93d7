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
  /// \param hashes of the samples, if they are known (Hashes)
  /// \pre field.HasCells(), and samples are whole numbers
  /// \throws std::bad_alloc
  static std::shared_ptr<const LabelSets> Make(
    const Field& field, std::vector<std::uint64_t> hashes = {});

  /// The sets of a field whose samples have changed in some cells since these were made. Reads no
  /// other samples.
  /// \param hashes as above
  /// \throws std::bad_alloc
  std::shared_ptr<const LabelSets> Updated(const Field& field, const std::vector<CellBox>& changed,
    std::vector<std::uint64_t> hashes = {}) const;

  /// All labels of the field, ascending.
  const std::vector<std::int64_t>& Labels() const { return this->All; }

  /// All labels of a node, ascending.
  const std::vector<std::int64_t>& LabelsOf(std::int64_t node) const
  {
    return this->OfNodes[static_cast<std::size_t>(node)];
  }

  /// Hashes of the samples, node by node (FieldFingerprint), so that nobody need read samples again
  /// to find changes. Empty if they are not known.
  const std::vector<std::uint64_t>& Hashes() const { return this->HashesOfNodes; }

  /// The bit of a label.
  static std::uint64_t BitOf(std::int64_t label)
  {
    return std::uint64_t(1) << (static_cast<std::uint64_t>(label) % 63);
  }

  /// The bits of some labels.
  static std::uint64_t BitsOf(const std::vector<double>& labels);

  /// True if a leaf of a node may have labels with these bits.
  bool Has(std::uint64_t bits, std::int64_t node, int leaf) const
  {
    return (this->Leaves[static_cast<std::size_t>(node * CellBlocks::LeavesPerNode + leaf)] &
             bits) != 0;
  }

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
  std::vector<std::uint64_t> HashesOfNodes;
};

}

#endif
