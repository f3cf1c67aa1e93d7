// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes with random changes of bytes are read, or refused with a sentence. Nothing crashes, and
// memory stays within the sizes of chunks.

#include "Checks/ProcessMemory.h"
#include "Checks/Sanitized.h"
#include "Mutations.h"
#include "ZarrTesting.h"

#include <iostream>

namespace
{

using namespace TemporalCoherence;
namespace fs = std::filesystem;

constexpr int UsualMutations = 200; // of each file and compressor

/// Change one digit or, in bytes, one byte. The text mostly stays valid JSON.
std::string GentlyMutated(std::string text, std::mt19937& random)
{
  const bool isJson = text.front() == '{';
  std::size_t at = random() % text.size();
  at = isJson ? text.find_first_of("0123456789", at) : at;
  if (at != std::string::npos)
  {
    text[at] = static_cast<char>(isJson ? '0' + random() % 10 : random() % 256);
  }
  return text;
}

/// Change some bytes, or cut the text, or repeat a part of it.
std::string Mutated(std::string text, std::mt19937& random)
{
  const std::string letters = "0123456789-.,:[]{}\"\\/eE\0\xff <>|unaf";
  const auto below = [&](std::size_t count) { return random() % (count > 0 ? count : 1); };
  for (std::size_t i = 1 + below(4); i > 0; --i)
  {
    const std::size_t at = below(text.size());
    switch (random() % 6)
    {
      case 0:
        text.resize(at);
        break;
      case 1:
        text.insert(at, text.substr(below(text.size()), below(20)));
        break;
      case 2:
        text.erase(at, below(8));
        break;
      case 3:
        text.insert(at, 1, letters[below(letters.size())]);
        break;
      default:
        if (!text.empty())
        {
          text[at] =
            random() % 2 ? letters[below(letters.size())] : static_cast<char>(random() % 256);
        }
    }
  }
  return text;
}

/// Read all chunks of a volume, unless they are large.
/// \return chunks that were refused
int ReadAll(const VolumeFile& volume)
{
  int refused = 0;
  for (std::size_t level = 0; level < volume.Levels().size(); ++level)
  {
    const VolumeLevel& geometry = volume.Levels()[level];
    const std::size_t size = geometry.SamplesOfChunk() * SizeOf(volume.Type());
    const glm::ivec3 grid = glm::min(geometry.NumberOfChunks(), 3);
    if (size > (1U << 20U))
    {
      continue;
    }
    ForEachChunk(grid,
      [&](const glm::ivec3& chunk)
      {
        const auto room = std::make_unique<unsigned char[]>(size);
        std::string error;
        const bool isGood = volume.ReadChunk(level, chunk, room.get(), error);
        EXPECT_TRUE(isGood || !error.empty());
        refused += isGood ? 0 : 1;
      });
  }
  return refused;
}

/// Mutate each of some files many times.
void TestMutations(
  const ZarrWriterSettings& settings, const std::vector<std::string>& files, unsigned seed)
{
  SCOPED_TRACE(settings.Compressor);
  const TemporaryFolder folder;
  ZarrWriter writer;
  const bool isSharded = settings.Shard.x > 0;
  ASSERT_TRUE(writer.Open(folder.Path(), settings, TwoLevels()));
  ASSERT_TRUE(isSharded
      ? writer.WriteChunk(0, glm::ivec3(0), SomeBytes(4096 * SizeOf(settings.Type), 1).data())
      : bool(WriteTwoLevels(folder.Path(), settings)));
  std::mt19937 random(seed);
  int refused = 0;
  const double before = ProcessMemory::Resident();
  const bool isMeasured = !IsMemorySanitized && ProcessMemory::ResetPeak();
  for (const std::string& name : files)
  {
    const fs::path path = folder.Path() / name;
    const std::string good = ReadText(path);
    ASSERT_FALSE(good.empty()) << path;
    for (int i = 0; i < NumberOfMutations(UsualMutations); ++i)
    {
      ASSERT_TRUE(WriteZarrFile(path, i % 2 ? Mutated(good, random) : GentlyMutated(good, random)));
      std::string error;
      const auto volume = OpenZarr(folder.Path().string(), {}, error);
      EXPECT_TRUE(volume || !error.empty());
      refused += volume ? ReadAll(*volume) : 1;
    }
    ASSERT_TRUE(WriteZarrFile(path, good));
  }
  EXPECT_GT(refused, 0);
  // Only chunks of at most 1 MiB are read here.
  const double grown = ProcessMemory::Peak() - before;
  EXPECT_FALSE(isMeasured && grown > 64e6);
  std::cout << "Mutations of " << settings.Compressor << ": " << refused << " refused, " << grown
            << " bytes of memory\n";
}

TEST(ZarrMutations, Version2)
{
  ZarrWriterSettings settings;
  settings.Type = ScalarType::UInt16;
  unsigned seed = 1;
  for (const char* compressor : { "", "zlib", "gzip", "zstd", "blosc-blosclz", "blosc-lz4",
         "blosc-lz4hc", "blosc-zlib", "blosc-zstd" })
  {
    settings.Compressor = compressor;
    TestMutations(settings, { ".zattrs", "0/.zarray", "0/0/0/0/0/0" }, seed++);
  }
}

TEST(ZarrMutations, Version3)
{
  ZarrWriterSettings settings;
  settings.Format = 3;
  settings.Type = ScalarType::Float32;
  settings.Compressor = "zstd";
  unsigned seed = 100;
  for (const int shard : { 0, 2 })
  {
    settings.Shard = glm::ivec3(shard);
    TestMutations(settings, { "zarr.json", "0/zarr.json", "0/c/0/0/0/0/0" }, seed++);
    settings.IsIndexAtStart = settings.HasChecksum = true;
  }
}

}
