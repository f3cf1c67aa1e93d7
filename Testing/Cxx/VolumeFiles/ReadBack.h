// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ReadBack_h
#define Testing_ReadBack_h

#include "VolumeFiles/VolumeFile.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace ReadBack
{

using namespace TemporalCoherence;

/// A folder for the files of the running test, emptied at the begin. Tests may run at once.
inline std::string Folder(const std::string& name)
{
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / (name + '-' + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string() + '/';
}

/// Any number that tells places apart, in the range of T.
template <typename T>
T ValueAt(std::size_t level, const glm::ivec3& at)
{
  std::uint64_t hash = static_cast<std::uint64_t>(level) * 977;
  for (int axis = 0; axis < 3; ++axis)
  {
    hash = hash * 1315423911u + static_cast<std::uint64_t>(at[axis]) * 2654435761u + 7;
  }
  hash ^= hash >> 29;
  return static_cast<T>(static_cast<std::int64_t>(hash % 100003) - 50000);
}

/// The samples of a chunk; 0 beyond the end of the volume.
template <typename T>
std::vector<T> MakeChunk(
  std::size_t level, const glm::ivec3& first, const glm::ivec3& size, const glm::ivec3& volume)
{
  std::vector<T> samples;
  for (int z = first.z; z < first.z + size.z; ++z)
  {
    for (int y = first.y; y < first.y + size.y; ++y)
    {
      for (int x = first.x; x < first.x + size.x; ++x)
      {
        const glm::ivec3 at(x, y, z);
        const bool isInside = glm::all(glm::lessThan(at, volume));
        samples.push_back(isInside ? ValueAt<T>(level, at) : T(0));
      }
    }
  }
  return samples;
}

/// All chunks of a level of a volume, x fastest.
inline std::vector<glm::ivec3> ChunksOf(const VolumeLevel& level)
{
  std::vector<glm::ivec3> chunks;
  const glm::ivec3 count = level.NumberOfChunks();
  for (int z = 0; z < count.z; ++z)
  {
    for (int y = 0; y < count.y; ++y)
    {
      for (int x = 0; x < count.x; ++x)
      {
        chunks.emplace_back(x, y, z);
      }
    }
  }
  return chunks;
}

/// True if the samples of a chunk that are in the volume are equal.
template <typename T>
bool AreEqual(const VolumeLevel& level, const glm::ivec3& chunk, const std::vector<T>& one,
  const std::vector<T>& other)
{
  const glm::ivec3 inside = glm::min(level.Chunk, level.Dimensions - chunk * level.Chunk);
  for (int z = 0; z < inside.z; ++z)
  {
    for (int y = 0; y < inside.y; ++y)
    {
      const auto row = static_cast<std::size_t>((z * level.Chunk.y + y) * level.Chunk.x);
      if (std::memcmp(&one[row], &other[row], sizeof(T) * static_cast<std::size_t>(inside.x)) != 0)
      {
        return false;
      }
    }
  }
  return true;
}

/// Expect that a level has the values of ValueAt.
template <typename T>
void ExpectValues(const VolumeFile& volume, std::size_t level)
{
  const VolumeLevel& place = volume.Levels()[level];
  std::vector<T> samples(place.SamplesOfChunk());
  for (const glm::ivec3& chunk : ChunksOf(place))
  {
    std::string error;
    ASSERT_TRUE(volume.ReadChunk(level, chunk, samples.data(), error)) << error;
    EXPECT_EQ(error, "");
    const auto truth = MakeChunk<T>(level, chunk * place.Chunk, place.Chunk, place.Dimensions);
    ASSERT_TRUE(AreEqual(place, chunk, samples, truth))
      << "level " << level << ", chunk " << chunk.x << ' ' << chunk.y << ' ' << chunk.z;
  }
}

}

#endif
