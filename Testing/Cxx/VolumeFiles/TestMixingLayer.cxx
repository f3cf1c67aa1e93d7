// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The volume by formula that stands for large simulations: it looks the same in every size, type
// and part, and plain formats that MakeVolume writes are read back equal.

#include "MixingLayer.h"
#include "RawFiles.h"
#include "VolumeFiles/MetaImageVolume.h"
#include "VolumeWriters.h"

#include <vtk_tiff.h>

#include <cmath>

using namespace TemporalCoherence;

namespace
{

std::vector<float> AllValues(const glm::ivec3& size)
{
  std::vector<float> values(
    static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y * size.z));
  MixingLayer(size).Slices(0, size.z, ScalarType::Float32, values.data());
  return values;
}

}

TEST(MixingLayer, HasLightGasBelowAndHeavyGasAbove)
{
  const glm::ivec3 size(60, 50, 100);
  const std::vector<float> values = AllValues(size);
  const std::size_t slice = 60 * 50;
  EXPECT_LE(*std::max_element(values.begin(), values.begin() + 30 * slice), 30.0f);
  EXPECT_GE(*std::min_element(values.begin() + 70 * slice, values.end()), 225.0f);
  // Both gases are in the middle, in similar parts.
  const auto light = std::count_if(values.begin() + 45 * slice, values.begin() + 55 * slice,
    [](float value) { return value < 128.0f; });
  EXPECT_GT(light, 2 * 10 * 60 * 50 / 10);
  EXPECT_LT(light, 8 * 10 * 60 * 50 / 10);
}

TEST(MixingLayer, IsFolded)
{
  const glm::ivec3 size(100, 100, 100);
  const std::vector<float> values = AllValues(size);
  int folds = 0;
  for (std::size_t column = 0; column < 10000; ++column)
  {
    int crossings = 0;
    for (std::size_t z = 1; z < 100; ++z)
    {
      crossings +=
        (values[z * 10000 + column] < 128.0f) != (values[(z - 1) * 10000 + column] < 128.0f);
    }
    folds += crossings > 1;
  }
  EXPECT_GT(folds, 2000);
}

TEST(MixingLayer, ShowsTheSameInEverySize)
{
  // Cells of the small volume have the same centres as every third cell of the large one.
  const glm::ivec3 small(40, 30, 20), large = 3 * small;
  const std::vector<float> few = AllValues(small), many = AllValues(large);
  for (int z = 0; z < small.z; ++z)
  {
    for (int y = 0; y < small.y; ++y)
    {
      for (int x = 0; x < small.x; ++x)
      {
        const int i = x + small.x * (y + small.y * z);
        const int j = 3 * x + 1 + large.x * (3 * y + 1 + large.y * (3 * z + 1));
        ASSERT_NEAR(few[static_cast<std::size_t>(i)], many[static_cast<std::size_t>(j)], 0.1);
      }
    }
  }
}

TEST(MixingLayer, TypesAndPartsAgree)
{
  const glm::ivec3 size(301, 7, 9);
  const std::vector<float> values = AllValues(size);
  const MixingLayer layer(size);
  std::vector<std::uint8_t> bytes(values.size());
  std::vector<std::uint16_t> words(values.size());
  for (int z = 0; z < size.z; z += 3)
  {
    const std::size_t at = 301 * 7 * static_cast<std::size_t>(z);
    layer.Slices(z, 3, ScalarType::UInt8, bytes.data() + at);
    layer.Slices(z, 3, ScalarType::UInt16, words.data() + at);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    ASSERT_EQ(bytes[i], std::lround(values[i]));
    ASSERT_NEAR(words[i], values[i] * 257.0f, 0.6);
  }
}

TEST(MixingLayer, SizesOfLevels)
{
  EXPECT_EQ(SizeOfLevel({ 2048, 1, 1920 }, 0), glm::ivec3(2048, 1, 1920));
  EXPECT_EQ(SizeOfLevel({ 2047, 1, 1920 }, 2), glm::ivec3(512, 1, 480));
  EXPECT_TRUE(IsTypeOfMixingLayer(ScalarType::Float32));
  EXPECT_FALSE(IsTypeOfMixingLayer(ScalarType::Float64));
}

TEST(MixingLayer, IsWrittenAsMetaImage)
{
  const ScratchFolder folder;
  VolumeOrder order;
  order.Path = folder / "layer.mhd";
  order.Dimensions = { 33, 44, 55 };
  for (const ScalarType type : { ScalarType::UInt8, ScalarType::UInt16, ScalarType::Float32 })
  {
    order.Type = type;
    std::string error;
    ASSERT_TRUE(WriteMetaImage(order, error)) << error;
    const auto file = OpenMetaImage(order.Path, error);
    ASSERT_TRUE(file) << error;
    ASSERT_EQ(file->Type(), type);
    const VolumeLevel& level = file->Levels().front();
    ASSERT_EQ(level.Chunk, order.Dimensions); // small enough for one chunk
    std::vector<char> read(level.SamplesOfChunk() * SizeOf(type)), made(read.size());
    ASSERT_TRUE(file->ReadChunk(0, { 0, 0, 0 }, read.data(), error)) << error;
    MixingLayer(order.Dimensions).Slices(0, 55, type, made.data());
    EXPECT_EQ(read, made);
  }
  std::string error;
  order.Codec = "zip";
  EXPECT_FALSE(WriteMetaImage(order, error));
  ExpectSentence(error, "zip");
}

TEST(MixingLayer, IsWrittenAsTiff)
{
  const ScratchFolder folder;
  VolumeOrder order;
  order.Path = folder / "stack";
  order.Dimensions = { 600, 300, 3 }; // several strips
  order.Type = ScalarType::UInt16;
  std::vector<std::uint16_t> made(600 * 300 * 3), read(made.size());
  MixingLayer(order.Dimensions).Slices(0, 3, order.Type, made.data());
  for (const char* codec : { "", "lzw", "deflate" })
  {
    order.Codec = codec;
    std::string error;
    ASSERT_TRUE(WriteTiff(order, error)) << error;
    for (std::size_t z = 0; z < 3; ++z)
    {
      const std::string path = folder / ("stack/slice0000" + std::to_string(z) + ".tif");
      TIFF* const file = TIFFOpen(path.c_str(), "r");
      ASSERT_TRUE(file);
      for (std::uint32_t y = 0; y < 300; ++y)
      {
        ASSERT_EQ(TIFFScanlineSize(file), 1200);
        ASSERT_EQ(TIFFReadScanline(file, read.data() + (z * 300 + y) * 600, y, 0), 1);
      }
      TIFFClose(file);
    }
    EXPECT_EQ(read, made) << codec;
  }
  std::string error;
  order.Codec = "zip";
  EXPECT_FALSE(WriteTiff(order, error));
  ExpectSentence(error, "zip");
}
