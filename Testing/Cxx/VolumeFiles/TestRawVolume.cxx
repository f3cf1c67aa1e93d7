// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Plain samples are read in all types, byte orders and offsets, mapped and chunk by chunk, from any
// thread. Mistakes become sentences.

#include "RawFiles.h"

#include <limits>
#include <thread>

using namespace TemporalCoherence;

namespace
{

constexpr ScalarType AllTypes[] = { ScalarType::Int8, ScalarType::UInt8, ScalarType::Int16,
  ScalarType::UInt16, ScalarType::Int32, ScalarType::UInt32, ScalarType::Int64, ScalarType::UInt64,
  ScalarType::Float32, ScalarType::Float64 };

RawLayout LayoutOf(ScalarType type, const glm::ivec3& dimensions)
{
  RawLayout layout;
  layout.Type = type;
  layout.Dimensions = dimensions;
  return layout;
}

}

TEST(RawVolume, ReadsAllTypesOrdersAndOffsets)
{
  const ScratchFolder folder;
  const std::string path = folder / "volume.raw";
  for (const ScalarType type : AllTypes)
  {
    for (const bool bigEndian : { false, true })
    {
      for (const std::uint64_t offset : { 0u, 1u, 6u, 8u, 4097u })
      {
        DispatchScalarType(type,
          [&](auto zero)
          {
            using T = decltype(zero);
            RawLayout layout = LayoutOf(type, { 7, 5, 3 });
            layout.Offset = offset;
            layout.IsBigEndian = bigEndian;
            WriteFile(path, std::string(offset, '!') + SampleBytes<T>(7 * 5 * 3, bigEndian));
            std::string error;
            const std::unique_ptr<VolumeFile> file = OpenRaw(path, layout, error);
            ASSERT_TRUE(file) << error;
            ExpectSamples<T>(*file);
#ifndef _WIN32
            const bool inPlace =
              offset % sizeof(T) == 0 && (sizeof(T) == 1 || bigEndian == MachineIsBigEndian());
            EXPECT_EQ(file->MappedSamples(0) != nullptr, inPlace);
#endif
            EXPECT_EQ(file->MappedSamples(1), nullptr);
            EXPECT_FALSE(file->HasFailed(error));
          });
      }
    }
  }
}

TEST(RawVolume, SplitsSlicesAndRows)
{
  const ScratchFolder folder;
  const std::string path = folder / "large.raw";
  // Several slices in a chunk; parts of slices; parts of rows.
  for (const glm::ivec3 size : { glm::ivec3(601, 401, 23), glm::ivec3(1500, 1801, 2),
         glm::ivec3(2200003, 2, 2), glm::ivec3(1, 1, 5000000), glm::ivec3(1, 5000000, 1) })
  {
    RawLayout layout = LayoutOf(ScalarType::UInt16, size);
    layout.Offset = 3;
    std::uint64_t bytes = 0;
    ASSERT_TRUE(BytesOf(size, layout.Type, bytes));
    WriteFile(path, "abc" + SampleBytes<std::uint16_t>(bytes / 2, false));
    std::string error;
    const std::unique_ptr<VolumeFile> file = OpenRaw(path, layout, error);
    ASSERT_TRUE(file) << error;
    EXPECT_LE(file->Levels()[0].SamplesOfChunk() * 2, std::size_t(4) << 20);
    EXPECT_GE(file->Levels()[0].SamplesOfChunk() * 2, std::size_t(1) << 20);
    ExpectSamples<std::uint16_t>(*file);
  }
}

TEST(RawVolume, ThreadsReadTogether)
{
  const ScratchFolder folder;
  const std::string path = folder / "threads.raw";
  RawLayout layout = LayoutOf(ScalarType::Float32, { 400, 400, 40 });
  layout.IsBigEndian = true;
  WriteFile(path, SampleBytes<float>(400 * 400 * 40, true));
  std::string error;
  const std::unique_ptr<VolumeFile> file = OpenRaw(path, layout, error);
  ASSERT_TRUE(file) << error;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
  {
    threads.emplace_back([&] { ExpectSamples<float>(*file); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

TEST(RawVolume, TellsMistakes)
{
  const ScratchFolder folder;
  const std::string path = folder / "bad.raw";
  WriteFile(path, std::string(1000, 'x'));
  const auto expectError = [&](const RawLayout& layout)
  {
    std::string error;
    EXPECT_FALSE(OpenRaw(path, layout, error));
    ExpectSentence(error, "bad.raw");
  };
  RawLayout good = LayoutOf(ScalarType::UInt8, { 10, 10, 10 });
  std::string error;
  ASSERT_TRUE(OpenRaw(path, good, error)) << error;
  constexpr int most = std::numeric_limits<int>::max();
  for (const glm::ivec3 size : { glm::ivec3(0, 10, 10), glm::ivec3(10, -10, -10),
         glm::ivec3(10, 10, 11), glm::ivec3(most, most, most), glm::ivec3(most, most, 1) })
  {
    RawLayout layout = good;
    layout.Dimensions = size;
    expectError(layout);
    layout.Type = ScalarType::Float64;
    expectError(layout);
  }
  for (const std::uint64_t offset :
    { std::uint64_t(1), std::uint64_t(1001), std::numeric_limits<std::uint64_t>::max() - 5 })
  {
    RawLayout layout = good;
    layout.Offset = offset;
    expectError(layout);
  }
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  for (const double spacing : { 0.0, -1.0, notANumber, HUGE_VAL })
  {
    RawLayout layout = good;
    layout.Spacing.y = spacing;
    expectError(layout);
  }
  good.Origin.z = notANumber;
  expectError(good);
}

TEST(RawVolume, TellsOfFilesThatCannotBeOpened)
{
  const ScratchFolder folder;
  const RawLayout layout = LayoutOf(ScalarType::UInt8, { 1, 1, 1 });
  std::string error;
  EXPECT_FALSE(OpenRaw(folder / "missing.raw", layout, error));
  ExpectSentence(error, "missing.raw");
  EXPECT_FALSE(OpenRaw(folder / "", layout, error));
  ExpectSentence(error, "no regular file");
}

TEST(RawVolume, TellsOfChunksThatAreNot)
{
  const ScratchFolder folder;
  const std::string path = folder / "one.raw";
  WriteFile(path, "abcdefgh");
  std::string error;
  const auto file = OpenRaw(path, LayoutOf(ScalarType::UInt8, { 2, 2, 2 }), error);
  ASSERT_TRUE(file) << error;
  char samples[8];
  EXPECT_TRUE(file->ReadChunk(0, { 0, 0, 0 }, samples, error));
  for (const glm::ivec3 chunk : { glm::ivec3(1, 0, 0), glm::ivec3(0, 0, -1) })
  {
    EXPECT_FALSE(file->ReadChunk(0, chunk, samples, error));
    ExpectSentence(error, "one.raw");
  }
  EXPECT_FALSE(file->ReadChunk(1, { 0, 0, 0 }, samples, error));
  ExpectSentence(error, "one.raw");
}

TEST(RawVolume, IdentityFollowsFileAndLayout)
{
  const ScratchFolder folder;
  const std::string path = folder / "same.raw";
  WriteFile(path, "abcdefgh");
  RawLayout layout = LayoutOf(ScalarType::UInt8, { 2, 2, 1 });
  std::string error;
  const std::string first = OpenRaw(path, layout, error)->Identity();
  EXPECT_EQ(OpenRaw(path, layout, error)->Identity(), first);
  layout.Spacing.x = 1.0 + 1e-15;
  EXPECT_NE(OpenRaw(path, layout, error)->Identity(), first);
  layout.Spacing.x = 1.0;
  layout.Offset = 1;
  EXPECT_NE(OpenRaw(path, layout, error)->Identity(), first);
  layout.Offset = 0;
  std::filesystem::last_write_time(std::filesystem::u8path(path),
    std::filesystem::last_write_time(std::filesystem::u8path(path)) + std::chrono::microseconds(1));
  EXPECT_NE(OpenRaw(path, layout, error)->Identity(), first);
}
