// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/LabelSets.h"

#include "Scene/Field.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
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
constexpr std::uint64_t Several = std::uint64_t(1) << 63;

/// The labels of a node, which are mostly added many times in a row.
template <typename T>
class FoundLabels
{
public:
  void Add(T label)
  {
    if (this->Seen.empty() || label != this->Seen.back())
    {
      this->Seen.push_back(label);
    }
  }

  /// Take the labels, ascending, each once.
  void TakeTo(std::vector<std::int64_t>& labels)
  {
    std::sort(this->Seen.begin(), this->Seen.end());
    this->Seen.erase(std::unique(this->Seen.begin(), this->Seen.end()), this->Seen.end());
    labels.assign(this->Seen.begin(), this->Seen.end());
    this->Seen.clear();
  }

private:
  std::vector<T> Seen;
};

/// Finds the labels in the leaves of a node.
template <typename T>
class NodeScan
{
public:
  using Words = std::array<std::uint64_t, CellBlocks::LeavesPerNode>;

  NodeScan(const TypedField<T>& field, FoundLabels<T>& found)
    : Samples(field)
    , Found(found)
  {
  }

  /// \param firstCell of the node
  void Scan(const glm::ivec3& firstCell, Words& words)
  {
    words.fill(0);
    this->First = firstCell;
    const glm::ivec3 count =
      glm::min(this->Samples.Dimensions - firstCell, glm::ivec3(NodeSize + 1));
    for (int k = 0; k < count.z; ++k)
    {
      for (int j = 0; j < count.y; ++j)
      {
        std::array<Part, LeavesInRow> parts;
        this->ScanRow(this->Samples.At(firstCell + glm::ivec3(0, j, k)), count.x, parts);
        // A sample between leaves belongs to both.
        for (int z = LastLeaf(k); z >= FirstLeaf(k); --z)
        {
          for (int y = LastLeaf(j); y >= FirstLeaf(j); --y)
          {
            this->AddRow({ 0, y, z }, parts, words);
          }
        }
      }
    }
  }

private:
  /// The samples of a row in a leaf.
  struct Part
  {
    std::uint64_t Bits = 0; ///< 0: there are none
    T Label{};              ///< of the first sample
  };

  static int FirstLeaf(int sample) { return sample == 0 ? 0 : (sample - 1) / LeafSize; }
  static int LastLeaf(int sample) { return std::min(sample / LeafSize, LeavesInRow - 1); }

  void ScanRow(const T* row, int count, std::array<Part, LeavesInRow>& parts)
  {
    const std::int64_t stride = this->Samples.Strides.x;
    bool isUniform = true;
    for (int i = 1; i < count; ++i)
    {
      isUniform &= row[i * stride] == row[0];
    }
    this->Found.Add(row[0]);
    const std::uint64_t bit = LabelSets::BitOf(static_cast<std::int64_t>(row[0]));
    for (int leaf = 0; leaf < LeavesInRow && leaf * LeafSize + 1 < count; ++leaf)
    {
      Part& part = parts[static_cast<std::size_t>(leaf)];
      part = { bit, row[0] };
      if (!isUniform)
      {
        const int first = leaf * LeafSize, end = std::min(first + LeafSize + 1, count);
        part = { 0, row[first * stride] };
        for (int i = first; i < end; ++i)
        {
          const T label = row[i * stride];
          this->Found.Add(label);
          part.Bits |= LabelSets::BitOf(static_cast<std::int64_t>(label)) |
            (label != part.Label ? Several : 0);
        }
      }
    }
  }

  /// Add a row to a row of leaves.
  void AddRow(
    const glm::ivec3& leaves, const std::array<Part, LeavesInRow>& parts, Words& words) const
  {
    for (int x = 0; x < LeavesInRow; ++x)
    {
      const Part& part = parts[static_cast<std::size_t>(x)];
      const glm::ivec3 leaf(x, leaves.y, leaves.z);
      const glm::ivec3 first = this->First + LeafSize * leaf;
      if (part.Bits != 0 && glm::all(glm::lessThan(first, this->Samples.Dimensions - 1)))
      {
        const bool isOther = part.Label != *this->Samples.At(first);
        words[static_cast<std::size_t>(leaf.x + LeavesInRow * (leaf.y + LeavesInRow * leaf.z))] |=
          part.Bits | (isOther ? Several : 0);
      }
    }
  }

  TypedField<T> Samples;
  FoundLabels<T>& Found;
  glm::ivec3 First{ 0 };
};

}

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
            FoundLabels<T> found;
            NodeScan<T> scan{ TypedField<T>(field), found };
            typename NodeScan<T>::Words words;
            for (std::int64_t i = begin; i < end; ++i)
            {
              const std::int64_t node = nodes[static_cast<std::size_t>(i)];
              const glm::ivec3 place(
                node % along.x, node / along.x % along.y, node / along.x / along.y);
              scan.Scan(NodeSize * place, words);
              std::copy(words.begin(), words.end(),
                this->Leaves.begin() + node * CellBlocks::LeavesPerNode);
              found.TakeTo(this->OfNodes[static_cast<std::size_t>(node)]);
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

/// Find the labels of all nodes.
void LabelSets::FindAll()
{
  std::unordered_set<std::int64_t> all;
  for (const std::vector<std::int64_t>& labels : this->OfNodes)
  {
    all.insert(labels.begin(), labels.end());
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
  sets->Leaves.resize(nodes.size() * CellBlocks::LeavesPerNode);
  sets->OfNodes.resize(nodes.size());
  sets->HashesOfNodes = std::move(hashes);
  sets->Scan(field, nodes);
  sets->FindAll();
  return sets;
}

std::shared_ptr<const LabelSets> LabelSets::Updated(
  const Field& field, const std::vector<CellBox>& changed, std::vector<std::uint64_t> hashes) const
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
  sets->Scan(field, nodes);
  sets->FindAll();
  return sets;
}

std::uint64_t LabelSets::BitsOf(const std::vector<double>& labels)
{
  std::uint64_t bits = 0;
  for (const double label : labels)
  {
    bits |= BitOf(static_cast<std::int64_t>(label));
  }
  return bits;
}

}
