// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ZarrTesting_h
#define TemporalCoherence_ZarrTesting_h

#include "VolumeFiles/ZarrVolume.h"
#include "VolumeFiles/ZarrWriter.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace TemporalCoherence
{

/// A folder that is removed at the end of a test.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::random_device random;
    this->Root = std::filesystem::canonical(std::filesystem::temp_directory_path()) /
      ("zarr-" + std::to_string(random()) + '-' + std::to_string(random()));
    std::filesystem::create_directories(this->Root);
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Root, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& Path() const { return this->Root; }

private:
  std::filesystem::path Root;
};

using ChunkBytes = std::vector<unsigned char>;

/// Bytes that compress, and differ for each seed.
inline ChunkBytes SomeBytes(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  ChunkBytes bytes(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    bytes[i] = static_cast<unsigned char>(i % 16 == 0 ? random() : i / 64);
  }
  return bytes;
}

/// Call `function(chunk)` for each position in a grid.
template <typename Function>
void ForEachChunk(const glm::ivec3& grid, Function&& function)
{
  glm::ivec3 at;
  for (at.z = 0; at.z < grid.z; ++at.z)
  {
    for (at.y = 0; at.y < grid.y; ++at.y)
    {
      for (at.x = 0; at.x < grid.x; ++at.x)
      {
        function(at);
      }
    }
  }
}

inline unsigned SeedOf(std::size_t level, const glm::ivec3& chunk)
{
  return static_cast<unsigned>(level) * 1000U + static_cast<unsigned>(chunk.x) +
    10U * static_cast<unsigned>(chunk.y) + 100U * static_cast<unsigned>(chunk.z);
}

/// Read a chunk of any volume. A failed test names the error.
inline ChunkBytes ReadBytes(const VolumeFile& volume, std::size_t level, const glm::ivec3& chunk)
{
  ChunkBytes bytes(volume.Levels()[level].SamplesOfChunk() * SizeOf(volume.Type()));
  std::string error;
  EXPECT_TRUE(volume.ReadChunk(level, chunk, bytes.data(), error)) << error;
  return bytes;
}

inline std::unique_ptr<VolumeFile> OpenGood(
  const std::filesystem::path& path, const VolumeChoice& choice = {})
{
  std::string error;
  auto volume = OpenZarr(path.string(), choice, error);
  EXPECT_TRUE(volume) << error;
  return volume;
}

/// The sentence about what is wrong with a volume.
inline std::string ErrorOf(const std::filesystem::path& path, const VolumeChoice& choice = {})
{
  std::string error;
  EXPECT_FALSE(OpenZarr(path.string(), choice, error)) << path;
  EXPECT_FALSE(error.empty());
  EXPECT_EQ(error.empty() ? '.' : error.back(), '.') << error;
  return error;
}

/// The sentence about what is wrong with a chunk.
inline std::string ChunkErrorOf(const VolumeFile& volume, const glm::ivec3& chunk)
{
  ChunkBytes bytes(volume.Levels().front().SamplesOfChunk() * SizeOf(volume.Type()));
  std::string error;
  EXPECT_FALSE(volume.ReadChunk(0, chunk, bytes.data(), error));
  EXPECT_FALSE(error.empty());
  return error;
}

inline std::string ReadText(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

inline bool Mentions(const std::string& text, const std::string& words)
{
  return text.find(words) != std::string::npos;
}

/// Two small levels of 2 x 2 x 2 chunks and of one chunk. Blosc does not compress chunks of less
/// than 128 bytes; these have 512 samples.
inline std::vector<ZarrWriterLevel> TwoLevels()
{
  return { { { 30, 13, 7 }, { 16, 8, 4 }, { 0.5, 0.25, 2.0 }, { 1.0, 2.0, 3.0 } },
    { { 15, 7, 4 }, { 16, 8, 4 }, { 1.0, 0.5, 3.0 }, { 1.25, 2.125, 3.5 } } };
}

/// Write all chunks of both levels, without shards.
inline ::testing::AssertionResult WriteTwoLevels(
  const std::filesystem::path& folder, const ZarrWriterSettings& settings)
{
  ZarrWriter writer;
  bool isGood = writer.Open(folder, settings, TwoLevels());
  for (int level = 0; level < 2; ++level)
  {
    ForEachChunk(level == 0 ? glm::ivec3(2) : glm::ivec3(1),
      [&](const glm::ivec3& chunk)
      {
        const ChunkBytes bytes = SomeBytes(writer.SamplesOfChunk(level) * SizeOf(settings.Type),
          SeedOf(static_cast<std::size_t>(level), chunk));
        isGood = isGood && writer.WriteChunk(level, chunk, bytes.data());
      });
  }
  return isGood ? ::testing::AssertionSuccess()
                : ::testing::AssertionFailure() << "cannot write " << folder;
}

}

#endif
