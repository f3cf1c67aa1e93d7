// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// OME-Zarr volumes of MakeVolume are read back equal, all levels, with each codec and type. What it
// cannot write is told in a sentence, and it changes no volume that is there.

#include "MadeVolumes.h"
#include "VolumeFiles/ZarrVolume.h"

using namespace TemporalCoherence;

namespace
{

void WriteAndRead(const VolumeOrder& order)
{
  std::string error;
  ASSERT_TRUE(WriteZarr(order, error)) << error;
  const auto file = OpenZarr(order.Path, {}, error);
  ASSERT_TRUE(file) << error;
  ExpectLayer(*file, order);
}

}

TEST(MadeZarr, EachCodec)
{
  const ScratchFolder folder;
  for (const char* codec : { "", "none", "blosc-lz4", "blosc-zstd", "zstd", "gzip" })
  {
    SCOPED_TRACE(codec);
    VolumeOrder order = SmallOrder(folder / (std::string("layer-") + codec));
    order.Codec = codec;
    WriteAndRead(order);
  }
}

TEST(MadeZarr, EachType)
{
  const ScratchFolder folder;
  for (const ScalarType type : { ScalarType::UInt8, ScalarType::UInt16, ScalarType::Float32 })
  {
    VolumeOrder order = SmallOrder(folder / std::to_string(static_cast<int>(type)));
    order.Type = type;
    WriteAndRead(order);
  }
}

TEST(MadeZarr, MistakesAreTold)
{
  const ScratchFolder folder;
  VolumeOrder order = SmallOrder(folder / "layer");
  order.Codec = "zip";
  std::string error;
  EXPECT_FALSE(WriteZarr(order, error));
  ExpectSentence(error, "zip");
  order.Codec = "none";
  ASSERT_TRUE(WriteZarr(order, error)) << error;
  order.Type = ScalarType::Float32;
  EXPECT_FALSE(WriteZarr(order, error));
  ExpectSentence(error, "layer");
  order.Type = ScalarType::UInt8;
  const auto file = OpenZarr(order.Path, {}, error);
  ASSERT_TRUE(file) << error;
  ExpectLayer(*file, order);
  WriteFile(folder / "file", "no folder");
  order.Path = folder / "file/layer";
  EXPECT_FALSE(WriteZarr(order, error));
  ExpectSentence(error, "file/layer");
}
