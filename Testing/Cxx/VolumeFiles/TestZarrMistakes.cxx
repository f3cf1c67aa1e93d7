// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Mistakes in OME-Zarr volumes become sentences: wrong metadata, damaged chunks, and names and
// links that lead out of the volume's folder.

#include "ZarrTesting.h"

namespace
{

using namespace TemporalCoherence;
namespace fs = std::filesystem;

/// A replacement in a file, and words of the sentence that it causes.
struct Mistake
{
  std::string Old, New, Words;
};

/// Make each mistake alone, and expect its sentence.
void TestMistakes(
  const fs::path& volume, const fs::path& file, const std::vector<Mistake>& mistakes)
{
  const std::string good = ReadText(file);
  for (const Mistake& mistake : mistakes)
  {
    SCOPED_TRACE(mistake.Old + " -> " + mistake.New);
    std::string text = good;
    const std::size_t at = text.find(mistake.Old);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, mistake.Old.size(), mistake.New);
    ASSERT_TRUE(WriteZarrFile(file, text));
    const std::string error = ErrorOf(volume);
    EXPECT_TRUE(Mentions(error, mistake.Words)) << error;
  }
  ASSERT_TRUE(WriteZarrFile(file, good));
  EXPECT_TRUE(OpenGood(volume));
}

TEST(ZarrMistakes, InArraysOfVersion2)
{
  const TemporaryFolder folder;
  ZarrWriterSettings settings;
  settings.Compressor = "blosc-lz4";
  settings.Type = ScalarType::UInt16;
  ASSERT_TRUE(WriteTwoLevels(folder.Path(), settings));
  const std::string shape = "[1, 1, 7, 13, 30]", chunk = "[1, 1, 4, 8, 16]";
  TestMistakes(folder.Path(), folder.Path() / "0" / ".zarray",
    { { "\"zarr_format\": 2", "\"zarr_format\": 3", "zarr_format" },
      { "{", "", "not a valid JSON object" }, { "{", "[", "not a valid JSON object" },
      { shape, "[1, 1, 3, 5, 0]", "shape" }, { shape, "[1, 1, 3, 5, -7]", "shape" },
      { shape, "[1, 1, 3, 5, 2147483648]", "shape" }, { shape, "[1, 1, 3, 5, 7.5]", "shape" },
      { shape, "[1, 1, 3, 5, 18446744073709551617]", "shape" }, { shape, "7", "shape" },
      { shape, "{\"a\": 7}", "shape" }, { shape, "[7]", "1 axes" },
      { shape, "[1, 1, 1, 3, 5, 7]", "6 axes" }, { shape, "[1, 3, 5, 7]", "axes" },
      { chunk, "[1, 1, 2, 3, 0]", "chunks" }, { chunk, "[1, 1, 1, 32768, 32768]", "2 GiB" },
      { chunk, "[1, 1, 2147483647, 2147483647, 2147483647]", "2 GiB" },
      { chunk, "[2147483647, 2147483647, 2147483647, 2147483647, 2147483647]", "2 GiB" },
      { chunk, "[1, 2, 3]", "axes" }, { "<u2", "<c8", "dtype" }, { "<u2", "|u2", "dtype" },
      { "<u2", "<f2", "dtype" }, { "<u2", "<M8", "dtype" }, { "\"<u2\"", "[[\"a\", 1]]", "dtype" },
      { "<u2", "<f8", "another type of samples" },
      { "\"order\": \"C\"", "\"order\": \"F\"", "order" },
      { "\"filters\": null", "\"filters\": [{\"id\": \"delta\"}]", "filters" },
      { "\"dimension_separator\": \"/\"", "\"dimension_separator\": \"//\"", "separator" },
      { "\"dimension_separator\": \"/\"", "\"dimension_separator\": 5", "separator" },
      { "\"id\": \"blosc\"", "\"id\": \"lzma\"", "compressor" },
      { "\"id\": \"blosc\"", "\"ID\": \"blosc\"", "compressor" },
      { "\"fill_value\": 0", "\"fill_value\": 65536", "fill_value" },
      { "\"fill_value\": 0", "\"fill_value\": -1", "fill_value" },
      { "\"fill_value\": 0", "\"fill_value\": 0.5", "fill_value" },
      { "\"fill_value\": 0", "\"fill_value\": \"NaN\"", "fill_value" } });
}

TEST(ZarrMistakes, InArraysOfVersion3)
{
  const TemporaryFolder folder;
  ZarrWriterSettings settings;
  settings.Format = 3;
  settings.Compressor = "zstd";
  settings.Shard = { 2, 2, 2 };
  ZarrWriter writer;
  ASSERT_TRUE(writer.Open(folder.Path(), settings, TwoLevels()));
  const std::string inner = "\"chunk_shape\": [1, 1, 4, 8, 16], \"codecs\"";
  TestMistakes(folder.Path(), folder.Path() / "0" / "zarr.json",
    { { "\"zarr_format\": 3", "\"zarr_format\": 4", "zarr_format" },
      { "\"name\": \"regular\"", "\"name\": \"rectangular\"", "chunk_grid" },
      { "uint8", "complex64", "data_type" },
      { "\"shape\": [1, 1, 7", "\"shape\": [1, 1, -7", "shape" },
      { inner, "\"chunk_shape\": [1, 1, 4, 5, 16], \"codecs\"", "shards" },
      { inner, "\"chunk_shape\": [1, 2, 3, 4], \"codecs\"", "shards" },
      { inner, "\"chunk_shape\": [1, 1, 4, 8, 16], \"codec\"", "codecs" },
      { "zstd", "lzma", "codecs" }, { "\"name\": \"bytes\"", "\"name\": \"crc32c\"", "codecs" },
      { "sharding_indexed", "sharding", "codecs" }, { "\"end\"", "\"middle\"", "index" },
      { "\"index_codecs\"", "\"codecs_of_index\"", "index" },
      { "\"name\": \"default\"", "\"name\": \"other\"", "chunk_key_encoding" },
      { "\"fill_value\": 0", "\"fill_value\": 256", "fill_value" } });
}

TEST(ZarrMistakes, InImages)
{
  const TemporaryFolder folder;
  ASSERT_TRUE(WriteTwoLevels(folder.Path(), {}));
  const std::string scale = "\"scale\": [1, 1, 2, 0.25, 0.5]";
  const std::string path = "\"path\": \"1\"";
  TestMistakes(folder.Path(), folder.Path() / ".zattrs",
    { { "\"datasets\"", "\"data\"", "datasets" }, { path, "\"path\": \"2\"", "does not exist" },
      { path, "\"path\": 1", "name" }, { path, "\"path\": \".\"", "holds no Zarr array" },
      { scale, "\"scale\": [1, 1, 2, 0.25]", "coordinateTransformations" },
      { scale, "\"scale\": [1, 1, 2, 0.25, 0]", "coordinateTransformations" },
      { scale, "\"scale\": [1, 1, 2, 0.25, -1]", "coordinateTransformations" },
      { scale, "\"scale\": [1, 1, 2, 0.25, null]", "coordinateTransformations" },
      { scale, "\"path\": \"scales\"", "coordinateTransformations" },
      { "\"type\": \"scale\"", "\"type\": \"rotation\"", "coordinateTransformations" },
      { "\"name\": \"t\", \"type\": \"time\"", "\"name\": \"t\", \"type\": \"space\"", "axes" },
      { "\"axes\": [", "\"axes\": [\"a\", ", "axes" },
      { "\"axes\": [", "\"axes\": 5, \"a\": [", "axes" },
      { "{", std::string(70, '[') + "{", "not a valid JSON object" } });
}

TEST(ZarrMistakes, LevelsMustShrink)
{
  const TemporaryFolder folder;
  std::vector<ZarrWriterLevel> levels = TwoLevels();
  levels[1].Dimensions.z = 8;
  ZarrWriter writer;
  ASSERT_TRUE(writer.Open(folder.Path(), {}, levels));
  EXPECT_TRUE(Mentions(ErrorOf(folder.Path()), "larger than the level before it"));
}

TEST(ZarrMistakes, InPaths)
{
  const TemporaryFolder folder;
  EXPECT_TRUE(Mentions(ErrorOf(""), "path"));
  EXPECT_TRUE(Mentions(ErrorOf(std::string("a\0b", 3)), "null"));
  EXPECT_TRUE(Mentions(ErrorOf(folder.Path() / "none"), "cannot be opened"));
  EXPECT_TRUE(Mentions(ErrorOf(folder.Path()), "holds no Zarr array"));
  ASSERT_TRUE(WriteZarrFile(folder.Path() / "file", "text"));
  EXPECT_TRUE(Mentions(ErrorOf(folder.Path() / "file"), "cannot be opened"));
  ASSERT_TRUE(WriteZarrFile(folder.Path() / ".zattrs", std::string((16U << 20U) + 1, ' ')));
  EXPECT_TRUE(Mentions(ErrorOf(folder.Path()), "16 MiB"));
}

TEST(ZarrMistakes, NamesStayInside)
{
  const TemporaryFolder folder;
  const fs::path root = folder.Path() / "volume";
  ASSERT_TRUE(WriteTwoLevels(root, {}));
  ASSERT_TRUE(WriteTwoLevels(folder.Path() / "other", {}));
  const std::string outside = (folder.Path() / "other" / "1").string();
  std::vector<Mistake> mistakes;
  for (const std::string& name :
    { std::string("../other/1"), std::string("1/../../other/1"), std::string("1/.."), outside,
      "/" + outside, std::string("1\\u0000"), std::string(), std::string("..\\\\other\\\\1") })
  {
    mistakes.push_back({ "\"path\": \"1\"", "\"path\": \"" + name + '"', "within the volume" });
    if (!name.empty())
    {
      EXPECT_TRUE(Mentions(ErrorOf(root, { 0, 0, name }), "within the volume"));
    }
  }
  TestMistakes(root, root / ".zattrs", mistakes);
}

TEST(ZarrMistakes, LinksStayInside)
{
  const TemporaryFolder folder;
  const fs::path root = folder.Path() / "volume", other = folder.Path() / "other";
  ASSERT_TRUE(WriteTwoLevels(root, {}));
  ASSERT_TRUE(WriteTwoLevels(other, {}));
  // The user may name a link.
  fs::create_directory_symlink(root, folder.Path() / "link");
  EXPECT_TRUE(OpenGood(folder.Path() / "link"));
  // Links within the folder are allowed.
  fs::rename(root / "1", root / "level");
  fs::create_directory_symlink("level", root / "1");
  const auto volume = OpenGood(root);
  ASSERT_TRUE(volume);
  const fs::path chunk = root / "0" / "0" / "0" / "1" / "1" / "1";
  fs::remove(chunk);
  fs::create_symlink(other / "0" / "0" / "0" / "1" / "1" / "1", chunk);
  EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, glm::ivec3(1)), "leads out"));
  fs::remove(chunk);
  fs::create_symlink("nowhere", chunk);
  EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, glm::ivec3(1)), "cannot be found"));
  fs::remove_all(root / "0" / "0");
  fs::create_directory_symlink(other / "0" / "0", root / "0" / "0");
  EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, glm::ivec3(0)), "leads out"));
  fs::remove(root / "1");
  fs::create_directory_symlink(other / "1", root / "1");
  EXPECT_TRUE(Mentions(ErrorOf(root), "leads out"));
  // A sibling whose name starts like the volume's folder is outside, too.
  fs::rename(other, folder.Path() / "volume2");
  fs::remove(root / "1");
  fs::create_directory_symlink(folder.Path() / "volume2" / "1", root / "1");
  EXPECT_TRUE(Mentions(ErrorOf(root), "leads out"));
  fs::remove(root / "1");
  fs::rename(root / "level", root / "1");
  fs::remove(root / ".zattrs");
  fs::create_symlink(folder.Path() / "volume2" / ".zattrs", root / ".zattrs");
  EXPECT_TRUE(Mentions(ErrorOf(root), "leads out"));
}

/// Cut, extend and change a chunk.
void TestDamage(const ZarrWriterSettings& settings)
{
  SCOPED_TRACE(settings.Compressor);
  const TemporaryFolder folder;
  ASSERT_TRUE(WriteTwoLevels(folder.Path(), settings));
  ZarrWriter writer;
  ASSERT_TRUE(writer.Open(folder.Path(), settings, TwoLevels()));
  const auto volume = OpenGood(folder.Path());
  ASSERT_TRUE(volume);
  const fs::path path = writer.PathOfChunk(0, glm::ivec3(0));
  const std::string good = ReadText(path);
  const auto expectError = [&](const std::string& bytes)
  {
    ASSERT_TRUE(WriteZarrFile(path, bytes));
    const std::string error = ChunkErrorOf(*volume, glm::ivec3(0));
    EXPECT_TRUE(Mentions(error, path.string())) << error;
  };
  for (std::size_t size = 0; size < good.size(); ++size)
  {
    expectError(good.substr(0, size));
  }
  expectError(std::string(200000, 'a'));
  // A chunk of the right form, with other samples: fewer, and more.
  for (const int x : { 15, 17 })
  {
    ZarrWriter other;
    ASSERT_TRUE(other.Open(folder.Path() / "other", settings, { { { 30, 13, 7 }, { x, 8, 4 } } }));
    ASSERT_TRUE(other.WriteChunk(0, glm::ivec3(0), SomeBytes(4000, 5).data()));
    expectError(ReadText(other.PathOfChunk(0, glm::ivec3(0))));
  }
  fs::remove(path);
  fs::create_directory(path);
  EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, glm::ivec3(0)), "not a regular file"));
}

TEST(ZarrMistakes, DamagedChunks)
{
  ZarrWriterSettings settings;
  settings.Type = ScalarType::Float32;
  for (const char* compressor : { "", "zlib", "gzip", "zstd", "blosc-blosclz", "blosc-lz4",
         "blosc-lz4hc", "blosc-zlib", "blosc-zstd" })
  {
    settings.Compressor = compressor;
    TestDamage(settings);
  }
  settings.Format = 3;
  settings.HasChecksum = true;
  for (const char* compressor : { "", "zstd" })
  {
    settings.Compressor = compressor;
    TestDamage(settings);
  }
}

TEST(ZarrMistakes, DamagedShards)
{
  ZarrWriterSettings settings;
  settings.Format = 3;
  settings.Shard = { 2, 2, 2 };
  for (const bool isAtStart : { false, true })
  {
    settings.IsIndexAtStart = isAtStart;
    const TemporaryFolder folder;
    ZarrWriter writer;
    ASSERT_TRUE(writer.Open(folder.Path(), settings, { TwoLevels().front() }));
    ASSERT_TRUE(writer.WriteChunk(0, glm::ivec3(0), SomeBytes(4096, 1).data()));
    const auto volume = OpenGood(folder.Path());
    ASSERT_TRUE(volume);
    const fs::path path = writer.PathOfChunk(0, glm::ivec3(0));
    const std::string good = ReadText(path);
    ASSERT_EQ(good.size(), 4096U + 8 * 16 + 4);
    const std::size_t index = isAtStart ? 0 : 4096;
    std::string bad = good;
    bad[index + 7] = 1; // 2^56 bytes behind
    ASSERT_TRUE(WriteZarrFile(path, bad));
    EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, glm::ivec3(0)), "behind the file's end"));
    bad = good;
    bad[index + 9] = 1; // 256 bytes too few
    ASSERT_TRUE(WriteZarrFile(path, bad));
    EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, glm::ivec3(0)), "size"));
    bad = good;
    bad.replace(index + 16, 16, std::string(16, '\xff'));
    ASSERT_TRUE(WriteZarrFile(path, bad));
    EXPECT_EQ(ReadBytes(*volume, 0, { 1, 0, 0 }), ChunkBytes(512, 0));
    ASSERT_TRUE(WriteZarrFile(path, good.substr(0, 100)));
    EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, glm::ivec3(0)), "too short for its index"));
  }
}

TEST(ZarrMistakes, ChunksOutsideOfTheGrid)
{
  const TemporaryFolder folder;
  ASSERT_TRUE(WriteTwoLevels(folder.Path(), {}));
  const auto volume = OpenGood(folder.Path());
  ASSERT_TRUE(volume);
  EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, { 2, 0, 0 }), "no such chunk"));
  EXPECT_TRUE(Mentions(ChunkErrorOf(*volume, { 0, -1, 0 }), "no such chunk"));
  std::string error;
  unsigned char sample = 0;
  EXPECT_FALSE(volume->ReadChunk(2, glm::ivec3(0), &sample, error));
}

}
