// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes of OME-Zarr read back what was written: all types of samples, compressors, byte orders
// and names of chunks, in versions 2 and 3 of Zarr.

#include "VolumeFiles/ChunkCodec.h"
#include "ZarrTesting.h"

#include <array>
#include <cmath>
#include <limits>
#include <thread>

namespace
{

using namespace TemporalCoherence;
namespace fs = std::filesystem;

void ExpectTwoLevels(const VolumeFile& volume)
{
  ASSERT_EQ(volume.Levels().size(), 2U);
  for (std::size_t level = 0; level < 2; ++level)
  {
    ForEachChunk(volume.Levels()[level].NumberOfChunks(),
      [&](const glm::ivec3& chunk)
      {
        const ChunkBytes read = ReadBytes(volume, level, chunk);
        EXPECT_EQ(read, SomeBytes(read.size(), SeedOf(level, chunk)));
      });
  }
}

/// Write and read volumes of all types.
void TestTypes(ZarrWriterSettings settings)
{
  for (int type = 0; type < 10; ++type)
  {
    settings.Type = static_cast<ScalarType>(type);
    for (const bool isBigEndian : { false, true })
    {
      settings.IsBigEndian = isBigEndian;
      SCOPED_TRACE(settings.Compressor + ", type " + std::to_string(type));
      const TemporaryFolder folder;
      ASSERT_TRUE(WriteTwoLevels(folder.Path(), settings));
      const auto volume = OpenGood(folder.Path());
      ASSERT_TRUE(volume);
      EXPECT_EQ(volume->Type(), settings.Type);
      ExpectTwoLevels(*volume);
    }
  }
}

void TestSeparators(const ZarrWriterSettings& like)
{
  ZarrWriterSettings settings = like;
  for (const char separator : { '.', '/' })
  {
    settings.Separator = separator;
    TestTypes(settings);
  }
}

TEST(Zarr, ReadsAllTypesAndCompressors)
{
  ZarrWriterSettings settings;
  for (const char* compressor : { "", "zlib", "gzip", "zstd", "blosc-blosclz", "blosc-lz4",
         "blosc-lz4hc", "blosc-zlib", "blosc-zstd" })
  {
    settings.Compressor = compressor;
    TestSeparators(settings);
  }
}

TEST(Zarr, ReadsVersion3)
{
  ZarrWriterSettings settings;
  settings.Format = 3;
  for (const char* compressor : { "", "gzip", "zstd", "blosc-lz4", "blosc-zstd" })
  {
    settings.Compressor = compressor;
    settings.HasChecksum = !settings.HasChecksum;
    TestSeparators(settings);
  }
}

void TestShards(const ZarrWriterSettings& settings)
{
  const TemporaryFolder folder;
  ZarrWriter writer;
  // 4 x 3 x 2 chunks, in shards of 2 x 2 x 2 that reach beyond the volume.
  ASSERT_TRUE(writer.Open(folder.Path(), settings, { { { 64, 24, 8 }, { 16, 8, 4 } } }));
  const glm::ivec3 shard = settings.Shard;
  const std::size_t bytes = 512 * SizeOf(settings.Type);
  for (const int x : { 0, 1 })
  {
    ChunkBytes samples;
    ForEachChunk(shard,
      [&](const glm::ivec3& inner)
      {
        const ChunkBytes chunk = SomeBytes(bytes, SeedOf(0, inner + glm::ivec3(x, 1, 0) * shard));
        samples.insert(samples.end(), chunk.begin(), chunk.end());
      });
    ASSERT_TRUE(writer.WriteChunk(0, { x, 1, 0 }, samples.data()));
  }
  const auto volume = OpenGood(folder.Path());
  ASSERT_TRUE(volume);
  EXPECT_EQ(volume->Levels().front().Chunk, glm::ivec3(16, 8, 4));
  ForEachChunk(volume->Levels().front().NumberOfChunks(),
    [&](const glm::ivec3& chunk)
    {
      const bool isWritten = chunk.y / shard.y == 1;
      EXPECT_EQ(ReadBytes(*volume, 0, chunk),
        isWritten ? SomeBytes(bytes, SeedOf(0, chunk)) : ChunkBytes(bytes, 0));
    });
}

TEST(Zarr, ReadsShards)
{
  ZarrWriterSettings settings;
  settings.Format = 3;
  settings.Type = ScalarType::UInt16;
  settings.Shard = { 2, 2, 2 };
  for (const char* compressor : { "", "zstd", "blosc-lz4" })
  {
    for (const bool isAtStart : { false, true })
    {
      settings.Compressor = compressor;
      settings.IsIndexAtStart = isAtStart;
      TestShards(settings);
    }
  }
}

TEST(Zarr, PlacesLevels)
{
  const TemporaryFolder folder;
  ASSERT_TRUE(WriteTwoLevels(folder.Path(), {}));
  std::string text = ReadText(folder.Path() / ".zattrs");
  const auto expectPlaces = [&](double scale, double shift)
  {
    const auto volume = OpenGood(folder.Path());
    ASSERT_TRUE(volume);
    const std::vector<ZarrWriterLevel> levels = TwoLevels();
    for (std::size_t i = 0; i < 2; ++i)
    {
      const VolumeLevel& level = volume->Levels()[i];
      EXPECT_EQ(level.Dimensions, levels[i].Dimensions);
      EXPECT_EQ(level.Chunk, levels[i].Chunk);
      EXPECT_EQ(level.Spacing, levels[i].Scale * scale);
      EXPECT_EQ(level.Origin, levels[i].Translation * scale + shift);
    }
  };
  expectPlaces(1.0, 0.0);
  const std::string all = R"("coordinateTransformations": [{"type": "scale", "scale": [1,1,2,2,2]},
{"type": "translation", "translation": [0, 0, 8, 8, 8]}], "datasets")";
  text.replace(text.find("\"datasets\""), 10, all);
  ASSERT_TRUE(WriteZarrFile(folder.Path() / ".zattrs", text));
  expectPlaces(2.0, 8.0);
}

/// Write a plain array without an image, with its first chunk only.
void WritePlain(const fs::path& folder, const std::string& shape, const std::string& chunks,
  const std::string& samples, const std::string& firstChunk)
{
  ASSERT_TRUE(WriteZarrFile(folder / ".zarray",
    R"({"zarr_format": 2, "shape": )" + shape + R"(, "chunks": )" + chunks +
      R"(, "dtype": "|u1", "compressor": null, "fill_value": 9, "order": "C", "filters": []})"));
  ASSERT_TRUE(WriteZarrFile(folder / firstChunk, samples));
}

TEST(Zarr, ReadsPlainArraysAndGroups)
{
  const TemporaryFolder folder;
  const fs::path& root = folder.Path();
  WritePlain(root / "10", "[3, 4]", "[2, 3]", "abcdef", "0.0");
  WritePlain(root / "9" / "a", "[2, 1, 2, 3]", "[1, 1, 2, 3]", "uvwxyz", "1.0.0.0");
  const auto picture = OpenGood(root);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->Levels().front().Dimensions, glm::ivec3(4, 3, 1));
  EXPECT_EQ(picture->Levels().front().Spacing, glm::dvec3(1.0));
  EXPECT_EQ(ReadBytes(*picture, 0, { 0, 0, 0 }), (ChunkBytes{ 'a', 'b', 'c', 'd', 'e', 'f' }));
  EXPECT_EQ(ReadBytes(*picture, 0, { 1, 1, 0 }), ChunkBytes(6, 9));
  const auto volume = OpenGood(root, { 1, 0, "9/a" });
  ASSERT_TRUE(volume);
  EXPECT_EQ(ReadBytes(*volume, 0, { 0, 0, 0 }), (ChunkBytes{ 'u', 'v', 'w', 'x', 'y', 'z' }));
  EXPECT_TRUE(OpenGood(root / "10" / ".zarray"));
  EXPECT_TRUE(Mentions(ErrorOf(root, { 2, 0, "9/a" }), "2 channels"));
  EXPECT_TRUE(Mentions(ErrorOf(root, { 0, 1, "9/a" }), "1 time points"));
  EXPECT_TRUE(Mentions(ErrorOf(root, { 0, 0, "8" }), "does not exist"));
}

/// The writer shares some functions with the reader, so these bytes are given as numbers.
TEST(Zarr, ReadsGivenBytes)
{
  const std::string digits = "123456789";
  EXPECT_EQ(Crc32c(reinterpret_cast<const unsigned char*>(digits.data()), 9), 0xe3069283U);
  const TemporaryFolder folder;
  ASSERT_TRUE(WriteZarrFile(folder.Path() / ".zarray",
    R"({"zarr_format": 2, "shape": [1, 2], "chunks": [1, 2], "dtype": ">i4", "compressor": null,
"fill_value": 0, "order": "C", "filters": null})"));
  ASSERT_TRUE(
    WriteZarrFile(folder.Path() / "0.0", std::string("\x01\x02\x03\x04\xff\xff\xff\xfe", 8)));
  const auto volume = OpenGood(folder.Path());
  ASSERT_TRUE(volume);
  const ChunkBytes bytes = ReadBytes(*volume, 0, glm::ivec3(0));
  std::array<std::int32_t, 2> values{};
  std::memcpy(values.data(), bytes.data(), bytes.size());
  EXPECT_EQ(values[0], 0x01020304);
  EXPECT_EQ(values[1], -2);
}

TEST(Zarr, FindsImagesInGroups)
{
  const TemporaryFolder folder;
  ZarrWriterSettings settings;
  ASSERT_TRUE(WriteZarrFile(folder.Path() / ".zattrs", R"({"bioformats2raw.layout": 3})"));
  ASSERT_TRUE(WriteZarrFile(folder.Path() / "OME" / ".zattrs", R"({"series": ["0"]})"));
  ASSERT_TRUE(WriteTwoLevels(folder.Path() / "0", settings));
  const auto volume = OpenGood(folder.Path());
  ASSERT_TRUE(volume);
  ExpectTwoLevels(*volume);
  EXPECT_TRUE(OpenGood(folder.Path() / "0", { 0, 0, "image" }));
  EXPECT_TRUE(Mentions(ErrorOf(folder.Path() / "OME"), "holds no Zarr array"));
}

/// Channels and time points of one chunk follow each other.
TEST(Zarr, ChoosesChannelAndTime)
{
  for (const char* compressor : { "", "blosc-lz4", "gzip" })
  {
    ZarrWriterSettings settings;
    settings.Compressor = compressor;
    settings.Channels = settings.TimePoints = 3;
    settings.ChannelsOfChunk = settings.TimePointsOfChunk = 2;
    const TemporaryFolder folder;
    ZarrWriter writer;
    ASSERT_TRUE(writer.Open(folder.Path(), settings, { { { 3, 2, 1 }, { 3, 2, 1 } } }));
    ASSERT_EQ(writer.SamplesOfChunk(0), 24U);
    for (int i = 0; i < 4; ++i)
    {
      const ChunkBytes bytes = SomeBytes(24, static_cast<unsigned>(i));
      ASSERT_TRUE(writer.WriteChunk(0, glm::ivec3(0), bytes.data(), i % 2, i / 2));
    }
    for (int i = 0; i < 9; ++i)
    {
      const int channel = i % 3, time = i / 3;
      const auto volume = OpenGood(folder.Path(), { channel, time, "" });
      ASSERT_TRUE(volume);
      const ChunkBytes bytes = SomeBytes(24, static_cast<unsigned>(channel / 2 + time / 2 * 2));
      const auto first = bytes.begin() + 6 * (channel % 2 + time % 2 * 2);
      EXPECT_EQ(ReadBytes(*volume, 0, glm::ivec3(0)), ChunkBytes(first, first + 6));
    }
    EXPECT_TRUE(Mentions(ErrorOf(folder.Path(), { 3, 0, "" }), "3 channels"));
    EXPECT_TRUE(Mentions(ErrorOf(folder.Path(), { 0, -1, "" }), "3 time points"));
  }
}

/// A missing chunk has the fill value.
template <typename T>
void TestFill(ScalarType type, const std::string& json, T value)
{
  for (const int format : { 2, 3 })
  {
    ZarrWriterSettings settings;
    settings.Type = type;
    settings.Format = format;
    settings.FillValue = json;
    settings.IsBigEndian = true;
    const TemporaryFolder folder;
    ZarrWriter writer;
    ASSERT_TRUE(writer.Open(folder.Path(), settings, TwoLevels()));
    const auto volume = OpenGood(folder.Path());
    ASSERT_TRUE(volume) << json;
    const ChunkBytes bytes = ReadBytes(*volume, 0, glm::ivec3(1));
    for (std::size_t i = 0; i < 512; ++i)
    {
      T read;
      std::memcpy(&read, bytes.data() + i * sizeof(T), sizeof(T));
      EXPECT_TRUE(read == value || (read != read && value != value)) << json;
    }
  }
}

TEST(Zarr, FillsMissingChunks)
{
  TestFill<std::uint8_t>(ScalarType::UInt8, "200", 200);
  TestFill<std::uint8_t>(ScalarType::UInt8, "true", 1);
  TestFill<std::int8_t>(ScalarType::Int8, "-128", -128);
  TestFill<std::uint16_t>(ScalarType::UInt16, "513", 513);
  TestFill<std::uint16_t>(ScalarType::UInt16, "null", 0);
  TestFill<std::int32_t>(ScalarType::Int32, "5.0", 5);
  TestFill<std::int64_t>(
    ScalarType::Int64, "-9223372036854775808", std::numeric_limits<std::int64_t>::min());
  TestFill<std::uint64_t>(
    ScalarType::UInt64, "18446744073709551615", std::numeric_limits<std::uint64_t>::max());
  TestFill<float>(ScalarType::Float32, "\"NaN\"", std::nanf(""));
  TestFill<float>(ScalarType::Float32, "\"0x3fc00000\"", 1.5F);
  TestFill<double>(ScalarType::Float64, "\"-Infinity\"", -std::numeric_limits<double>::infinity());
  TestFill<double>(ScalarType::Float64, "\"Infinity\"", std::numeric_limits<double>::infinity());
  TestFill<double>(ScalarType::Float64, "0.1", 0.1);
}

TEST(Zarr, IdentityTellsChanges)
{
  const TemporaryFolder folder;
  ZarrWriterSettings settings;
  settings.Channels = 2;
  ZarrWriter writer;
  ASSERT_TRUE(writer.Open(folder.Path(), settings, TwoLevels()));
  const std::string first = OpenGood(folder.Path())->Identity();
  EXPECT_EQ(first, OpenGood(folder.Path())->Identity());
  EXPECT_NE(first, OpenGood(folder.Path(), { 1, 0, "" })->Identity());
  const fs::path array = folder.Path() / "1" / ".zarray";
  fs::last_write_time(array, fs::last_write_time(array) + std::chrono::seconds(5));
  EXPECT_NE(first, OpenGood(folder.Path())->Identity());
}

TEST(Zarr, ReadsAndWritesInManyThreads)
{
  const TemporaryFolder folder;
  ZarrWriterSettings settings;
  settings.Compressor = "blosc-lz4";
  settings.Type = ScalarType::UInt16;
  settings.IsBigEndian = true;
  ZarrWriter writer;
  ASSERT_TRUE(writer.Open(folder.Path(), settings, { { glm::ivec3(64), glm::ivec3(16) } }));
  const auto inThreads = [](const auto& work)
  {
    std::vector<std::thread> threads;
    for (int z = 0; z < 4; ++z)
    {
      threads.emplace_back(
        [&work, z]
        {
          ForEachChunk(
            { 4, 4, 1 }, [&](const glm::ivec3& chunk) { work(chunk + glm::ivec3(0, 0, z)); });
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  };
  inThreads([&](const glm::ivec3& chunk)
    { EXPECT_TRUE(writer.WriteChunk(0, chunk, SomeBytes(8192, SeedOf(0, chunk)).data())); });
  const auto volume = OpenGood(folder.Path());
  ASSERT_TRUE(volume);
  inThreads([&](const glm::ivec3& chunk)
    { EXPECT_EQ(ReadBytes(*volume, 0, chunk), SomeBytes(8192, SeedOf(0, chunk))); });
}

}
