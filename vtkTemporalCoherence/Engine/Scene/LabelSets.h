// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelSets_h
#define TemporalCoherence_LabelSets_h

#include "Scene/CellBlocks.h"
#include "Scene/CellBox.h"
#include "Scene/SampleChanges.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

class LabelIndex;
struct Field;

/// Which labels a field has, and where: a set of labels for each leaf of cells. A label is a whole
/// number that names a part of the data. Sets are built once, never changed, and shared.
///
/// A set is a word. Its bits stand for the labels of the node around the leaf, in their order: each
/// label has one of 63 bits, which several share only if the node has more labels. The last bit
/// says that the leaf has more than one label. Nodes with one label have no sets.
class LabelSets
{
public:
  /// Read all samples once, in parallel.
  /// \param hashes  of the samples, if they are known (Hashes)
  /// \pre field.HasCells(), and samples are whole numbers
  /// \throws std::bad_alloc
  static std::shared_ptr<const LabelSets> Make(
    const Field& field, std::vector<std::uint64_t> hashes = {});

  /// The sets of a field whose samples have changed in some cells since these were made. Reads no
  /// other samples.
  /// \param hashes as above
  /// \param told   changes in place until now, if any are known
  /// \throws std::bad_alloc
  std::shared_ptr<const LabelSets> Updated(const Field& field, const std::vector<CellBox>& changed,
    std::vector<std::uint64_t> hashes = {}, std::vector<SampleChange> told = {}) const;

  /// All labels of the field, ascending.
  const std::vector<std::int64_t>& Labels() const { return this->All; }

  /// All labels of a node, ascending.
  const std::vector<std::int64_t>& LabelsOf(std::int64_t node) const
  {
    return this->OfNodes[static_cast<std::size_t>(node)]->Labels;
  }

  /// Hashes of the samples, node by node (FieldFingerprint), so that nobody need read samples again
  /// to find changes. Empty if they are not known.
  const std::vector<std::uint64_t>& Hashes() const { return this->HashesOfNodes; }

  /// Changes of samples that are known without hashes.
  const std::vector<SampleChange>& Changes() const { return this->Told; }

  /// The bits of some labels in the sets of a node.
  /// \param areAmong tells for a label whether it is one of them
  template <typename AreAmong>
  std::uint64_t BitsOf(std::int64_t node, const AreAmong& areAmong) const
  {
    const std::vector<std::int64_t>& labels = this->LabelsOf(node);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      bits |= static_cast<std::uint64_t>(areAmong(labels[i])) << BitAt(i);
    }
    return bits;
  }

  /// The leaves of a node whose sets share bits with these, one bit each.
  std::uint64_t LeavesWith(std::uint64_t bits, std::int64_t node) const
  {
    const std::vector<std::uint64_t>& leaves =
      this->OfNodes[static_cast<std::size_t>(node)]->Leaves;
    if (leaves.empty())
    {
      return (bits & 1u) != 0 ? ~std::uint64_t(0) : 0;
    }
    std::uint64_t found = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      found |= static_cast<std::uint64_t>((leaves[i] & bits) != 0) << i;
    }
    return found;
  }

  /// The leaves of a node whose sets have labels of an index, one bit each.
  std::uint64_t LeavesWith(const LabelIndex& labels, std::int64_t node) const;

  /// One bit for each leaf of a node that has several labels.
  std::uint64_t MixedLeaves(std::int64_t node) const { return this->LeavesWith(Several, node); }

private:
  static constexpr int LabelBits = 63;
  static constexpr std::uint64_t Several = std::uint64_t(1) << LabelBits;

  struct NodeLabels
  {
    std::vector<std::int64_t> Labels;  ///< ascending
    std::vector<std::uint64_t> Leaves; ///< their sets; empty if there is one label
  };

  template <typename T>
  class NodeScan;

  /// The bit of the label at a position in the list of its node.
  static std::size_t BitAt(std::size_t position) { return position % LabelBits; }

  void Scan(const Field& field, const std::vector<std::int64_t>& nodes);
  void FindAll();

  std::vector<std::int64_t> All;
  std::vector<std::shared_ptr<const NodeLabels>> OfNodes; ///< which nodes of one label share
  std::vector<std::uint64_t> HashesOfNodes;
  std::vector<SampleChange> Told;
};

}

#endif
