// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/LabelSets.h"

#include "Scene/Field.h"
#include "Scene/LabelIndex.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <numeric>
#include <unordered_set>
#include <utility>

namespace TemporalCoherence
{
namespace
{

constexpr int LeafSize = CellBlocks::LeafSize, NodeSize = CellBlocks::NodeSize;
constexpr int LeavesInRow = NodeSize / LeafSize;

/// The first and the last leaf of a row that have a sample: one between leaves belongs to both.
int FirstLeafOf(int sample)
{
  return sample == 0 ? 0 : (sample - 1) / LeafSize;
}
int LastLeafOf(int sample)
{
  return std::min(sample / LeafSize, LeavesInRow - 1);
}

}

/// Finds the labels of nodes, and of their leaves.
template <typename T>
class LabelSets::NodeScan
{
public:
  explicit NodeScan(const TypedField<T>& field)
    : Samples(field)
  {
  }

  /// \param firstCell of the node
  std::shared_ptr<const NodeLabels> Scan(const glm::ivec3& firstCell)
  {
    this->First = firstCell;
    this->Count = glm::min(this->Samples.Dimensions - firstCell, glm::ivec3(NodeSize + 1));
    this->FindLabels();
    if (this->Found.size() > 1)
    {
      return std::make_shared<const NodeLabels>(NodeLabels{ this->Found, this->FindLeaves() });
    }
    if (!this->LastOfOne || this->LastOfOne->Labels != this->Found)
    {
      this->LastOfOne = std::make_shared<const NodeLabels>(NodeLabels{ this->Found, {} });
    }
    return this->LastOfOne;
  }

private:
  void FindLabels()
  {
    std::vector<std::int64_t>& found = this->Found;
    found.clear();
    const std::int64_t stride = this->Samples.Strides.x;
    for (int k = 0; k < this->Count.z; ++k)
    {
      for (int j = 0; j < this->Count.y; ++j)
      {
        const T* const row = this->Samples.At(this->First + glm::ivec3(0, j, k));
        bool isUniform = true;
        for (int i = 1; i < this->Count.x; ++i)
        {
          isUniform &= row[i * stride] == row[0];
        }
        for (int i = 0; i < (isUniform ? 1 : this->Count.x); ++i)
        {
          // Labels mostly come many times in a row.
          const auto label = static_cast<std::int64_t>(row[i * stride]);
          if (found.empty() || found.back() != label)
          {
            found.push_back(label);
          }
        }
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  /// The sets of all leaves.
  std::vector<std::uint64_t> FindLeaves()
  {
    std::vector<std::uint64_t> leaves(CellBlocks::LeavesPerNode);
    this->LastBit = 0;
    for (int k = 0; k < this->Count.z; ++k)
    {
      for (int j = 0; j < this->Count.y; ++j)
      {
        this->AddRow(j, k, leaves);
      }
    }
    for (int leaf = 0; leaf < CellBlocks::LeavesPerNode; ++leaf)
    {
      std::uint64_t& set = leaves[static_cast<std::size_t>(leaf)];
      const bool mayShare = this->Found.size() > LabelBits; // then a bit does not tell
      const bool hasSeveral = mayShare || (set & (set - 1)) != 0;
      set = this->HasCells(leaf) ? set | (hasSeveral ? Several : 0) : 0;
    }
    return leaves;
  }

  /// True if a leaf of the node lies within the field.
  bool HasCells(int leaf) const
  {
    const glm::ivec3 first = LeafSize * glm::ivec3(leaf & 3, leaf >> 2 & 3, leaf >> 4);
    return glm::all(glm::lessThan(first, this->Count - 1));
  }

  /// The bit of a label of the node.
  std::uint64_t BitOf(T label)
  {
    if (label != this->LastLabel || this->LastBit == 0)
    {
      const auto place =
        std::lower_bound(this->Found.begin(), this->Found.end(), static_cast<std::int64_t>(label));
      this->LastLabel = label;
      this->LastBit = std::uint64_t(1)
        << BitAt(static_cast<std::size_t>(place - this->Found.begin()));
    }
    return this->LastBit;
  }

  /// Add a row of samples to the sets of its leaves.
  void AddRow(int j, int k, std::vector<std::uint64_t>& leaves)
  {
    const T* const row = this->Samples.At(this->First + glm::ivec3(0, j, k));
    const std::int64_t stride = this->Samples.Strides.x;
    for (int x = 0; x < LeavesInRow && x * LeafSize + 1 < this->Count.x; ++x)
    {
      const T* const begin = row + x * LeafSize * stride;
      const int count = std::min(this->Count.x - x * LeafSize, LeafSize + 1);
      std::uint64_t bits = this->BitOf(*begin);
      for (int i = 1; i < count; ++i)
      {
        bits |= this->BitOf(begin[i * stride]);
      }
      this->AddTo(x, j, k, bits, leaves);
    }
  }

  /// Add bits to the leaves at place x of a row that have the samples (j, k).
  static void AddTo(int x, int j, int k, std::uint64_t bits, std::vector<std::uint64_t>& leaves)
  {
    for (int z = FirstLeafOf(k); z <= LastLeafOf(k); ++z)
    {
      for (int y = FirstLeafOf(j); y <= LastLeafOf(j); ++y)
      {
        leaves[static_cast<std::size_t>(x + LeavesInRow * (y + LeavesInRow * z))] |= bits;
      }
    }
  }

  TypedField<T> Samples;
  std::vector<std::int64_t> Found; ///< labels of the node, ascending
  std::shared_ptr<const NodeLabels> LastOfOne;
  glm::ivec3 First{ 0 }, Count{ 0 }; ///< samples of the node
  T LastLabel{};
  std::uint64_t LastBit = 0; ///< of LastLabel; 0: there is none yet
};

/// Scan some nodes, in parallel.
void LabelSets::Scan(const Field& field, const std::vector<std::int64_t>& nodes)
{
  const glm::ivec3 along = CellBlocks::NodesFor(field.Dimensions);
  std::atomic<bool> isOutOfMemory{ false };
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      constexpr std::int64_t grain = 64;
      ParallelForRanges(static_cast<std::int64_t>(nodes.size()), grain,
        [&](std::int64_t begin, std::int64_t end)
        {
          try
          {
            NodeScan<T> scan{ TypedField<T>(field) };
            for (std::int64_t i = begin; i < end; ++i)
            {
              const std::int64_t node = nodes[static_cast<std::size_t>(i)];
              const glm::ivec3 place(
                node % along.x, node / along.x % along.y, node / along.x / along.y);
              this->OfNodes[static_cast<std::size_t>(node)] = scan.Scan(NodeSize * place);
            }
          }
          catch (const std::bad_alloc&)
          {
            isOutOfMemory = true; // not every kind of threads passes exceptions on
          }
        });
    });
  if (isOutOfMemory)
  {
    throw std::bad_alloc();
  }
}

std::uint64_t LabelSets::LeavesWith(const LabelIndex& labels, std::int64_t node) const
{
  const auto areAmong = [&](std::int64_t label) { return labels.Has(label); };
  return this->LeavesWith(this->BitsOf(node, areAmong), node);
}

/// Find the labels of all nodes.
void LabelSets::FindAll()
{
  std::unordered_set<std::int64_t> all;
  const NodeLabels* last = nullptr;
  for (const std::shared_ptr<const NodeLabels>& node : this->OfNodes)
  {
    if (node.get() != last)
    {
      all.insert(node->Labels.begin(), node->Labels.end());
      last = node.get();
    }
  }
  this->All.assign(all.begin(), all.end());
  std::sort(this->All.begin(), this->All.end());
}

std::shared_ptr<const LabelSets> LabelSets::Make(
  const Field& field, std::vector<std::uint64_t> hashes)
{
  const auto sets = std::make_shared<LabelSets>();
  const glm::ivec3 along = CellBlocks::NodesFor(field.Dimensions);
  std::vector<std::int64_t> nodes(static_cast<std::size_t>(along.x) *
    static_cast<std::size_t>(along.y) * static_cast<std::size_t>(along.z));
  std::iota(nodes.begin(), nodes.end(), std::int64_t(0));
  sets->OfNodes.resize(nodes.size());
  sets->HashesOfNodes = std::move(hashes);
  sets->Scan(field, nodes);
  sets->FindAll();
  return sets;
}

std::shared_ptr<const LabelSets> LabelSets::Updated(const Field& field,
  const std::vector<CellBox>& changed, std::vector<std::uint64_t> hashes,
  std::vector<SampleChange> told) const
{
  const glm::ivec3 along = CellBlocks::NodesFor(field.Dimensions);
  std::vector<std::int64_t> nodes;
  for (const CellBox& box : changed)
  {
    const glm::ivec3 first = box.First / NodeSize;
    const glm::ivec3 last = glm::min((box.First + box.Size - 1) / NodeSize, along - 1);
    for (int k = first.z; k <= last.z; ++k)
    {
      for (int j = first.y; j <= last.y; ++j)
      {
        for (int i = first.x; i <= last.x; ++i)
        {
          nodes.push_back(i + along.x * (j + static_cast<std::int64_t>(along.y) * k));
        }
      }
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const auto sets = std::make_shared<LabelSets>(*this);
  sets->HashesOfNodes = std::move(hashes);
  sets->Told = std::move(told);
  sets->Scan(field, nodes);
  sets->FindAll();
  return sets;
}

}
