// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RawFiles_h
#define TemporalCoherence_RawFiles_h

#include "VolumeFiles/RawVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/// \file
/// Files of samples for tests.

namespace TemporalCoherence
{

/// A new folder, which is deleted with this object.
class ScratchFolder
{
public:
  ScratchFolder()
  {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    this->Path = std::filesystem::temp_directory_path() /
      ("volume-files-" + std::to_string(now) + '-' +
        std::to_string(reinterpret_cast<std::uintptr_t>(this)));
    std::filesystem::create_directories(this->Path);
  }

  ~ScratchFolder() { this->Remove(); }

  /// Delete the folder now, for programs that end before the destructor.
  void Remove() const
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }

  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string operator/(const std::string& name) const { return (this->Path / name).u8string(); }

private:
  std::filesystem::path Path;
};

inline void WriteFile(const std::string& path, const std::string& bytes)
{
  // Some file systems write a replaced file to the disk at once, which takes long.
  std::filesystem::remove(std::filesystem::u8path(path));
  std::ofstream stream(std::filesystem::u8path(path), std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::string ReadFile(const std::string& path)
{
  std::ifstream stream(std::filesystem::u8path(path), std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

/// A sample that differs from most others.
template <typename T>
T SampleAt(std::size_t index)
{
  return static_cast<T>(static_cast<std::int64_t>(index * 2654435761u % 1000003u) - 400000);
}

/// True if a number begins with its most significant byte in memory.
inline bool MachineIsBigEndian()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 0;
}

/// The bytes of `count` samples.
template <typename T>
std::string SampleBytes(std::size_t count, bool bigEndian)
{
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i)
  {
    const T sample = SampleAt<T>(i);
    char parts[sizeof(T)];
    std::memcpy(parts, &sample, sizeof(T));
    if (bigEndian != MachineIsBigEndian())
    {
      std::reverse(parts, parts + sizeof(T));
    }
    bytes.append(parts, sizeof(T));
  }
  return bytes;
}

/// Compare all samples of a volume, chunk by chunk and mapped, with SampleAt().
template <typename T>
void ExpectSamples(const VolumeFile& file)
{
  ASSERT_EQ(SizeOf(file.Type()), sizeof(T));
  const VolumeLevel& level = file.Levels().front();
  const auto indexOf = [&](const glm::ivec3& place)
  {
    const glm::ivec3& size = level.Dimensions;
    return static_cast<std::size_t>(place.x) +
      static_cast<std::size_t>(size.x) *
      (static_cast<std::size_t>(place.y) +
        static_cast<std::size_t>(size.y) * static_cast<std::size_t>(place.z));
  };
  std::vector<T> samples(level.SamplesOfChunk());
  const glm::ivec3 chunks = level.NumberOfChunks();
  std::size_t compared = 0, wrong = 0;
  for (int c = 0; c < chunks.x * chunks.y * chunks.z; ++c)
  {
    const glm::ivec3 chunk(c % chunks.x, c / chunks.x % chunks.y, c / chunks.x / chunks.y);
    std::string error;
    ASSERT_TRUE(file.ReadChunk(0, chunk, samples.data(), error)) << error;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const auto x = static_cast<int>(i % static_cast<std::size_t>(level.Chunk.x));
      const auto row = static_cast<int>(i / static_cast<std::size_t>(level.Chunk.x));
      const glm::ivec3 place =
        chunk * level.Chunk + glm::ivec3(x, row % level.Chunk.y, row / level.Chunk.y);
      if (glm::all(glm::lessThan(place, level.Dimensions)))
      {
        ++compared;
        wrong += samples[i] != SampleAt<T>(indexOf(place));
      }
    }
  }
  EXPECT_EQ(compared, indexOf(level.Dimensions - 1) + 1);
  EXPECT_EQ(wrong, 0u);
  if (const auto* mapped = static_cast<const T*>(file.MappedSamples(0)))
  {
    for (std::size_t i = 0; i < compared; ++i)
    {
      wrong += mapped[i] != SampleAt<T>(i);
    }
    EXPECT_EQ(wrong, 0u);
  }
}

/// Check that an error is a sentence for users, which names the file.
inline void ExpectSentence(const std::string& error, const std::string& name)
{
  EXPECT_NE(error.find(name), std::string::npos) << error;
  EXPECT_GT(error.size(), 30u) << error;
  EXPECT_EQ(error.empty() ? ' ' : error.back(), '.') << error;
  EXPECT_NE(error.find(';'), std::string::npos) << "no remedy: " << error;
}

}

#endif
