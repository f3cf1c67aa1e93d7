// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/FieldFingerprint.h"

#include "Acceleration/ValueRangePyramid.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr int NodeSize = ValueRangePyramid::NodeSize;

/// Initial value of a hash.
constexpr std::uint64_t Seed = 0x9e3779b97f4a7c15u;

/// How many cells farther than its own cells a sample affects the picture: one for normals, one for
/// points that rounding puts beside their cell.
constexpr int Reach = 2;

/// Hash eight more bytes, by the mixing of SplitMix64 (Steele et al. 2014). The mixing is
/// bijective: different hashes stay different while the bytes that follow are equal.
std::uint64_t Mix(std::uint64_t hash, std::uint64_t bytes)
{
  hash ^= bytes;
  hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
  return hash ^ hash >> 31;
}

template <typename T>
std::uint64_t MixRow(std::uint64_t hash, const T* samples, int count)
{
  const auto* bytes = reinterpret_cast<const std::byte*>(samples);
  std::size_t left = static_cast<std::size_t>(count) * sizeof(T);
  std::uint64_t word = 0;
  for (; left >= sizeof(word); left -= sizeof(word), bytes += sizeof(word))
  {
    std::memcpy(&word, bytes, sizeof(word));
    hash = Mix(hash, word);
  }
  if (left > 0)
  {
    word = 0;
    std::memcpy(&word, bytes, left);
    hash = Mix(hash, word);
  }
  return hash;
}

/// The first sample behind those of a node, along one axis. The last sample of all is in the last
/// node.
int EndOf(int node, int nodes, int samples)
{
  return node + 1 < nodes ? NodeSize * (node + 1) : samples;
}

/// The hashes of a row of nodes, computed in the order of memory: all nodes along x at the same
/// time.
/// \param from, end the nodes along x
/// \param node      y and z of the row
/// \param nodes     along each axis
/// \param hashes    of all nodes of the row
template <typename T>
void HashRow(const TypedField<T>& field, int from, int end, const glm::ivec2& node,
  const glm::ivec3& nodes, std::uint64_t* hashes)
{
  std::fill(hashes + from, hashes + end, Seed);
  const glm::ivec2 first = NodeSize * node;
  const glm::ivec2 last(
    EndOf(node.x, nodes.y, field.Dimensions.y), EndOf(node.y, nodes.z, field.Dimensions.z));
  std::array<T, NodeSize + 1> gathered;
  for (int k = first.y; k < last.y; ++k)
  {
    for (int j = first.x; j < last.x; ++j)
    {
      for (int n = from; n < end; ++n)
      {
        const int i = n * NodeSize;
        const int count = EndOf(n, nodes.x, field.Dimensions.x) - i;
        const T* row = field.At(i, j, k);
        if (field.Strides.x != 1)
        {
          for (int s = 0; s < count; ++s)
          {
            gathered[static_cast<std::size_t>(s)] = row[s * field.Strides.x];
          }
          row = gathered.data();
        }
        hashes[n] = MixRow(hashes[n], row, count);
      }
    }
  }
}

/// A row of nodes to hash, from one node along x up to another.
struct RowToHash
{
  int First = std::numeric_limits<int>::max(), End = 0;
};

}

FieldFingerprint FingerprintOf(const Field& field)
{
  const glm::ivec3 nodes = ValueRangePyramid::NodesFor(field.Dimensions);
  FieldFingerprint none;
  none.Nodes.resize(static_cast<std::size_t>(nodes.x) * static_cast<std::size_t>(nodes.y) *
    static_cast<std::size_t>(nodes.z));
  return FingerprintOf(field, none, { { glm::ivec3(0), field.Dimensions - 1 } });
}

FieldFingerprint FingerprintOf(
  const Field& field, const FieldFingerprint& last, const std::vector<SampleBox>& within)
{
  const glm::ivec3 nodes = ValueRangePyramid::NodesFor(field.Dimensions);
  FieldFingerprint print{ field, last.Nodes };
  std::vector<RowToHash> rows(
    static_cast<std::size_t>(nodes.y) * static_cast<std::size_t>(nodes.z));
  for (const SampleBox& box : within)
  {
    // The last node of a row may hold one sample more than the others.
    const glm::ivec3 first = glm::min(box.First / NodeSize, nodes - 1);
    const glm::ivec3 end = glm::min(box.Last / NodeSize + 1, nodes);
    for (int k = first.z; k < end.z; ++k)
    {
      for (int j = first.y; j < end.y; ++j)
      {
        RowToHash& row = rows[static_cast<std::size_t>(j + static_cast<std::int64_t>(nodes.y) * k)];
        row = { std::min(row.First, first.x), std::max(row.End, end.x) };
      }
    }
  }
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      const TypedField<decltype(type)> samples(field);
      ParallelFor(static_cast<std::int64_t>(rows.size()), 1,
        [&](std::int64_t row)
        {
          const RowToHash& toHash = rows[static_cast<std::size_t>(row)];
          if (toHash.First < toHash.End)
          {
            HashRow(samples, toHash.First, toHash.End, { row % nodes.y, row / nodes.y }, nodes,
              print.Nodes.data() + row * nodes.x);
          }
        });
    });
  return print;
}

namespace
{

/// The cells whose picture some samples affect.
std::vector<CellBox> CellsAround(const std::vector<SampleBox>& samples, const Field& field)
{
  const int reach = Reach + field.Shape->Abilities().Reach;
  std::vector<CellBox> boxes;
  for (const SampleBox& box : samples)
  {
    const glm::ivec3 first = glm::max(box.First - 1 - reach, 0);
    const glm::ivec3 last = glm::min(box.Last + 1 + reach, field.Dimensions - 1);
    boxes.push_back({ first, last - first });
  }
  return boxes;
}

}

std::vector<CellBox> ChangedCells(const FieldFingerprint& before, const FieldFingerprint& now,
  const std::optional<std::vector<SampleBox>>& within)
{
  const glm::ivec3 nodes = ValueRangePyramid::NodesFor(now.Samples.Dimensions);
  std::vector<SampleBox> changed;
  for (std::size_t i = 0; i < now.Nodes.size(); ++i)
  {
    if (before.Nodes[i] != now.Nodes[i])
    {
      // The last samples of a row may be in its last node, too.
      const auto node = static_cast<std::int64_t>(i);
      const glm::ivec3 place(node % nodes.x, node / nodes.x % nodes.y, node / nodes.x / nodes.y);
      changed.push_back({ NodeSize * place, NodeSize * (place + 1) });
    }
  }
  // Where few boxes are told they are more precise than nodes.
  constexpr std::size_t few = 16;
  if (!within || within->size() > few)
  {
    return CellsAround(changed, now.Samples);
  }
  std::vector<SampleBox> parts;
  for (const SampleBox& node : changed)
  {
    for (const SampleBox& box : *within)
    {
      const SampleBox part{ glm::max(node.First, box.First), glm::min(node.Last, box.Last) };
      if (!part.IsEmpty())
      {
        parts.push_back(part);
      }
    }
  }
  return CellsAround(parts, now.Samples);
}

}
