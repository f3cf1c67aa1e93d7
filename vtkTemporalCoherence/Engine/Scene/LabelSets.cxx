// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/LabelSets.h"

#include "Scene/Field.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <mutex>
#include <new>
#include <unordered_set>

namespace TemporalCoherence
{
namespace
{

constexpr int LeafSize = CellBlocks::LeafSize, NodeSize = CellBlocks::NodeSize;
constexpr int LeavesInRow = NodeSize / LeafSize;
constexpr std::uint64_t Several = std::uint64_t(1) << 63;

std::uint64_t BitOf(std::int64_t label)
{
  return std::uint64_t(1) << (static_cast<std::uint64_t>(label) % 63);
}

/// A set of labels, which are mostly added many times in a row.
template <typename T>
class FoundLabels
{
public:
  void Add(T label)
  {
    if (!this->HasLast || label != this->Last)
    {
      this->HasLast = true;
      this->Last = label;
      if constexpr (IsNarrow)
      {
        this->Has[PlaceOf(label)] = true;
      }
      else
      {
        this->Set.insert(static_cast<std::int64_t>(label));
      }
    }
  }

  /// Ascending.
  std::vector<std::int64_t> All() const
  {
    std::vector<std::int64_t> labels(this->Set.begin(), this->Set.end());
    std::sort(labels.begin(), labels.end());
    for (std::size_t place = 0; place < this->Has.size(); ++place)
    {
      if (this->Has[place])
      {
        labels.push_back(static_cast<std::int64_t>(place) + Lowest);
      }
    }
    return labels;
  }

private:
  static constexpr bool IsNarrow = sizeof(T) <= 2;
  static constexpr std::int64_t Lowest =
    IsNarrow ? static_cast<std::int64_t>(std::numeric_limits<T>::lowest()) : 0;

  static std::size_t PlaceOf(T label)
  {
    return static_cast<std::size_t>(static_cast<std::int64_t>(label) - Lowest);
  }

  bool HasLast = false;
  T Last{};
  std::unordered_set<std::int64_t> Set;                            ///< of wide types
  std::vector<bool> Has = std::vector<bool>(IsNarrow ? 65536 : 0); ///< of narrow ones, by place
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
    const std::uint64_t bit = BitOf(static_cast<std::int64_t>(row[0]));
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
          part.Bits |=
            BitOf(static_cast<std::int64_t>(label)) | (label != part.Label ? Several : 0);
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

std::shared_ptr<const LabelSets> LabelSets::Make(const Field& field)
{
  const auto sets = std::make_shared<LabelSets>();
  const glm::ivec3 along = CellBlocks::NodesFor(field.Dimensions);
  const std::int64_t nodes = static_cast<std::int64_t>(along.x) * along.y * along.z;
  sets->Leaves.resize(static_cast<std::size_t>(nodes) * CellBlocks::LeavesPerNode);
  std::mutex guard;
  bool isOutOfMemory = false;
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      constexpr std::int64_t grain = 512;
      ParallelForRanges(nodes, grain,
        [&](std::int64_t begin, std::int64_t end)
        {
          try
          {
            FoundLabels<T> found;
            NodeScan<T> scan{ TypedField<T>(field), found };
            typename NodeScan<T>::Words words;
            for (std::int64_t node = begin; node < end; ++node)
            {
              const glm::ivec3 place(
                node % along.x, node / along.x % along.y, node / along.x / along.y);
              scan.Scan(NodeSize * place, words);
              std::copy(words.begin(), words.end(),
                sets->Leaves.begin() + node * CellBlocks::LeavesPerNode);
            }
            const std::vector<std::int64_t> labels = found.All();
            const std::lock_guard<std::mutex> lock(guard);
            std::vector<std::int64_t> both;
            std::set_union(labels.begin(), labels.end(), sets->All.begin(), sets->All.end(),
              std::back_inserter(both));
            sets->All.swap(both);
          }
          catch (const std::bad_alloc&)
          {
            const std::lock_guard<std::mutex> lock(guard);
            isOutOfMemory = true; // not every kind of threads passes exceptions on
          }
        });
    });
  if (isOutOfMemory)
  {
    throw std::bad_alloc();
  }
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
