// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/SampleHash.h"

#include <algorithm>
#include <cstring>
#include <memory>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t MostChunks = 8;

}

std::uint64_t HashOf(const void* bytes, std::size_t count, std::uint64_t seed)
{
  constexpr std::uint64_t prime = 0x100000001b3u;
  std::uint64_t hash = (0xcbf29ce484222325u ^ seed) * prime;
  const auto* const first = static_cast<const std::byte*>(bytes);
  for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t))
  {
    std::uint64_t word = 0;
    std::memcpy(&word, first + i, std::min(count - i, sizeof(word)));
    hash = (hash ^ word) * prime;
    hash ^= hash >> 29;
  }
  return hash ^ count;
}

std::uint64_t HashOf(const VolumeFile& file, std::size_t level)
{
  const VolumeLevel& shape = file.Levels()[level];
  const std::string identity = file.Identity();
  std::uint64_t hash = HashOf(identity.data(), identity.size(), level);
  hash = HashOf(&shape.Dimensions, sizeof(shape.Dimensions), hash);
  const glm::i64vec3 grid(shape.NumberOfChunks());
  const std::int64_t chunks = grid.x * grid.y * grid.z;
  const std::size_t bytes = shape.SamplesOfChunk() * SizeOf(file.Type());
  const std::unique_ptr<std::byte[]> samples(new std::byte[bytes]());
  const std::int64_t count = std::min(chunks, MostChunks);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::int64_t chunk = (2 * i + 1) * chunks / (2 * count);
    const glm::ivec3 place(chunk % grid.x, chunk / grid.x % grid.y, chunk / grid.x / grid.y);
    std::string ignored; // frames tell it
    if (!file.ReadChunk(level, place, samples.get(), ignored))
    {
      std::fill_n(samples.get(), bytes, std::byte(0));
    }
    hash = HashOf(samples.get(), bytes, hash);
  }
  return hash;
}

}
