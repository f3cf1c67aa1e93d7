// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Imaris files of MakeVolume are read back equal, all levels, with each codec and type. What it
// cannot write is told in a sentence.

#include "MadeVolumes.h"
#include "VolumeFiles/Hdf5Volume.h"

using namespace TemporalCoherence;

TEST(MadeImaris, EachCodecAndType)
{
  const ScratchFolder folder;
  for (const ScalarType type : { ScalarType::UInt8, ScalarType::UInt16, ScalarType::Float32 })
  {
    for (const char* codec : { "", "none", "gzip" })
    {
      SCOPED_TRACE(codec);
      VolumeOrder order = SmallOrder(folder / "layer.ims");
      order.Type = type;
      order.Codec = codec;
      std::string error;
      ASSERT_TRUE(WriteImaris(order, error)) << error;
      const auto file = OpenHdf5(order.Path, {}, error);
      ASSERT_TRUE(file) << error;
      ExpectLayer(*file, order);
    }
  }
}

TEST(MadeImaris, MistakesAreTold)
{
  const ScratchFolder folder;
  VolumeOrder order = SmallOrder(folder / "layer.ims");
  order.Codec = "zip";
  std::string error;
  EXPECT_FALSE(WriteImaris(order, error));
  ExpectSentence(error, "zip");
  order.Codec = "gzip";
  order.Path = folder / "no folder/layer.ims";
  EXPECT_FALSE(WriteImaris(order, error));
  ExpectSentence(error, "no folder");
}
