// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/CoarseField.h"

#include "Acceleration/NodeRanges.h"
#include "OutOfCore/ChunkBricks.h"
#include "OutOfCore/ChunkCache.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t MostSamples = std::int64_t(1) << 22;

std::shared_ptr<StandIn> StandInOf(
  std::shared_ptr<std::vector<std::byte>> samples, ScalarType type, const glm::ivec3& size)
{
  const auto made = std::make_shared<StandIn>();
  made->Samples.Samples = samples->data();
  made->Samples.Type = type;
  made->Samples.Dimensions = size;
  made->Samples.Strides = { 1, size.x, static_cast<std::int64_t>(size.x) * size.y };
  made->Samples.Stamp = 1;
  made->Owner = std::move(samples);
  return made;
}

/// The coarsest level that is fine enough to tell something, if it is small.
std::shared_ptr<StandIn> FromLevel(const std::shared_ptr<const VolumeFile>& file, std::size_t level)
{
  const std::vector<VolumeLevel>& levels = file->Levels();
  std::size_t coarse = level + 1;
  while (coarse < levels.size() && CountOf(levels[coarse].Dimensions) > MostSamples)
  {
    ++coarse;
  }
  if (coarse >= levels.size() || glm::any(glm::lessThan(levels[coarse].Dimensions, glm::ivec3(2))))
  {
    return nullptr;
  }
  const VolumeLevel &own = levels[level], &taken = levels[coarse];
  const std::size_t bytes = SizeOf(file->Type());
  const auto samples = std::make_shared<std::vector<std::byte>>(
    static_cast<std::size_t>(CountOf(taken.Dimensions)) * bytes);
  ChunkCache chunks(file, coarse, 0);
  ChunkBricks(chunks, bytes).ReadAll(samples->data());
  if (chunks.NumberOfMistakes() > 0)
  {
    return nullptr;
  }
  const auto made = StandInOf(samples, file->Type(), taken.Dimensions);
  made->First = (taken.Origin - own.Origin) / own.Spacing;
  made->Step = taken.Spacing / own.Spacing;
  return made;
}

/// The middle of each block's range of values.
template <typename T>
std::shared_ptr<StandIn> FromRanges(const KnownRanges& known, const glm::ivec3& dimensions)
{
  // Leaves if there are few, else nodes.
  const glm::ivec3 nodes = CellBlocks::NodesFor(dimensions);
  const glm::ivec3 leaves = (dimensions - 1) / CellBlocks::LeafSize;
  const bool areLeaves = CountOf(leaves) <= MostSamples;
  const glm::ivec3 size = areLeaves ? leaves : (dimensions - 1) / CellBlocks::NodeSize;
  if (glm::any(glm::lessThan(size, glm::ivec3(2))))
  {
    return nullptr;
  }
  const auto* const ranges = reinterpret_cast<const Range<T>*>(known.Bytes.get());
  const auto samples = std::make_shared<std::vector<std::byte>>(
    static_cast<std::size_t>(CountOf(size)) * sizeof(float));
  auto* sample = reinterpret_cast<float*>(samples->data());
  for (int z = 0; z < size.z; ++z)
  {
    for (int y = 0; y < size.y; ++y)
    {
      for (int x = 0; x < size.x; ++x)
      {
        const glm::ivec3 node = areLeaves ? glm::ivec3(x, y, z) / 4 : glm::ivec3(x, y, z);
        const std::int64_t number =
          node.x + nodes.x * (node.y + static_cast<std::int64_t>(nodes.y) * node.z);
        const Range<T>& range = areLeaves
          ? ranges[CellBlocks::LeavesPerNode * number + (x & 3) + 4 * (y & 3) + 16 * (z & 3)]
          : ranges[CellBlocks::LeavesPerNode * CountOf(nodes) + number];
        *sample++ = static_cast<float>(
          0.5 * static_cast<double>(range.Min) + 0.5 * static_cast<double>(range.Max));
      }
    }
  }
  const auto made = StandInOf(samples, ScalarType::Float32, size);
  made->Step = glm::dvec3(areLeaves ? CellBlocks::LeafSize : CellBlocks::NodeSize);
  made->First = 0.5 * made->Step;
  return made;
}

}

std::shared_ptr<const StandIn> MakeStandIn(
  const std::shared_ptr<const VolumeFile>& file, std::size_t level, const KnownRanges& ranges)
{
  if (auto made = FromLevel(file, level))
  {
    return made;
  }
  return DispatchScalarType(file->Type(),
    [&](auto type) -> std::shared_ptr<const StandIn>
    { return FromRanges<decltype(type)>(ranges, file->Levels()[level].Dimensions); });
}

}
