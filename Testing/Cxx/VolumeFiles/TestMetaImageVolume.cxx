// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// MetaImages are read as VTK wrote them, and in the variants of their headers. Mistakes become
// sentences, and headers do not lead out of their folder.

#include "HeaderFiles.h"

#include "VolumeFiles/MetaImageVolume.h"

using namespace TemporalCoherence;

namespace
{

const char* const Header = "ObjectType = Image\nNDims = 3\nBinaryData = True\n"
                           "BinaryDataByteOrderMSB = False\nCompressedData = False\n"
                           "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 1 2 3\n"
                           "ElementSpacing = 0.5 1 2\nDimSize = 5 4 3\nHeaderSize = 0\n"
                           "ElementType = MET_USHORT\nElementDataFile = image.raw\n";

class MetaImageVolume : public testing::Test
{
protected:
  MetaImageVolume()
  {
    WriteFile(this->Folder / "image.raw", SampleBytes<std::uint16_t>(60, false));
  }

  std::unique_ptr<VolumeFile> Open(const std::string& text, std::string& error) const
  {
    WriteFile(this->Folder / "image.mhd", text);
    return OpenMetaImage(this->Folder / "image.mhd", error);
  }

  void ExpectVolume(const std::string& text) const
  {
    std::string error;
    const std::unique_ptr<VolumeFile> file = this->Open(text, error);
    ASSERT_TRUE(file) << error;
    ExpectPlaces(*file, { 5, 4, 3 }, { 1.0, 2.0, 3.0 }, { 0.5, 1.0, 2.0 });
    ExpectSamples<std::uint16_t>(*file);
  }

  void ExpectErrorWith(const std::string& part, const std::string& by) const
  {
    std::string error;
    EXPECT_FALSE(this->Open(Replaced(Header, part, by), error)) << by;
    ExpectSentence(error, "image.");
  }

  const ScratchFolder Folder;
};

}

TEST_F(MetaImageVolume, ReadsWhatVtkWrites)
{
  for (const char* name : { "written.mhd", "written.mha" })
  {
    for (int number = 0; number < 10; ++number)
    {
      const auto type = static_cast<ScalarType>(number);
      if (type == ScalarType::Int64 || type == ScalarType::UInt64)
      {
        continue; // VTK does not write these
      }
      WriteMetaImage(this->Folder / name, MakeImage(type));
      std::string error;
      const std::unique_ptr<VolumeFile> file = OpenMetaImage(this->Folder / name, error);
      ASSERT_TRUE(file) << error;
      EXPECT_EQ(file->Type(), type);
      ExpectPlaces(*file, { 5, 4, 3 }, { 11.0, 19.5, 30.75 }, { 0.5, 0.5, 0.25 });
      DispatchScalarType(type, [&](auto zero) { ExpectSamples<decltype(zero)>(*file); });
    }
  }
}

TEST_F(MetaImageVolume, ReadsLongIntegers)
{
  WriteFile(this->Folder / "image.raw", SampleBytes<std::int64_t>(60, false));
  std::string error;
  const auto file = this->Open(Replaced(Header, "MET_USHORT", "MET_LONG_LONG"), error);
  ASSERT_TRUE(file) << error;
  ExpectSamples<std::int64_t>(*file);
}

TEST_F(MetaImageVolume, ReadsVariants)
{
  this->ExpectVolume(Header);
  this->ExpectVolume(Replaced(Header, "Offset", "Position"));
  this->ExpectVolume(Replaced(Header, "Offset", "Origin"));
  this->ExpectVolume(Replaced(Header, "ElementSpacing", "ElementSize"));
  this->ExpectVolume(Replaced(Header, "DimSize = ", "DimSize:"));
  this->ExpectVolume(Replaced(Header, "NDims = 3\n", "NDims = 3\r\n"));
  this->ExpectVolume(Replaced(Header, "image.raw", "./image.raw"));
  this->ExpectVolume(Replaced(Header, "image.raw", this->Folder / "image.raw"));
  this->ExpectVolume(Replaced(Header, "image.raw\n", "image.raw"));
  const std::string bytes = SampleBytes<std::uint16_t>(60, true);
  WriteFile(this->Folder / "image.raw", "head" + bytes);
  const std::string big = Replaced(Header, "MSB = False", "MSB = True");
  this->ExpectVolume(Replaced(big, "HeaderSize = 0", "HeaderSize = 4"));
  this->ExpectVolume(Replaced(big, "HeaderSize = 0", "HeaderSize = -1"));
  const std::string local = Replaced(big, "image.raw", "LOCAL");
  this->ExpectVolume(local + bytes);
  this->ExpectVolume(Replaced(local, "LOCAL\n", "LOCAL\r\n") + bytes);
  this->ExpectVolume(Replaced(local, "HeaderSize = 0", "HeaderSize = -1") + "rest" + bytes);
}

TEST_F(MetaImageVolume, TellsMistakes)
{
  this->ExpectErrorWith("ElementDataFile", "ElementFile");
  this->ExpectErrorWith("NDims = 3", "NDims = 2");
  this->ExpectErrorWith("NDims = 3", "NDims = 3\nElementNumberOfChannels = 3");
  this->ExpectErrorWith("BinaryData = True", "BinaryData = False");
  this->ExpectErrorWith("CompressedData = False", "CompressedData = True");
  this->ExpectErrorWith("Matrix = 1 0", "Matrix = 0 1");
  this->ExpectErrorWith("Matrix = 1 0", "Matrix = 1");
  this->ExpectErrorWith("Offset = 1 2 3", "Offset = 1 2");
  this->ExpectErrorWith("Spacing = 0.5", "Spacing = 0");
  this->ExpectErrorWith("Spacing = 0.5", "Spacing = -0.5");
  this->ExpectErrorWith("DimSize = 5", "DimSize = 0");
  this->ExpectErrorWith("DimSize = 5", "DimSize = 6");
  this->ExpectErrorWith("DimSize = 5 4 3", "DimSize = 2147483647 2147483647 2147483647");
  this->ExpectErrorWith("DimSize = 5", "DimSize = 99999999999999999999");
  this->ExpectErrorWith("HeaderSize = 0", "HeaderSize = -2");
  this->ExpectErrorWith("HeaderSize = 0", "HeaderSize = 9223372036854775807");
  this->ExpectErrorWith("MET_USHORT", "MET_LONG");
  this->ExpectErrorWith("image.raw", "LIST");
  this->ExpectErrorWith("image.raw", "image%03d.raw 1 3 1");
  this->ExpectErrorWith("image.raw", "missing.image.raw");
  this->ExpectErrorWith("image.raw", "");
  this->ExpectErrorWith("image.raw", ".");
  this->ExpectErrorWith("image.raw", "LOCAL");
}

TEST_F(MetaImageVolume, StaysInItsFolder)
{
  const std::filesystem::path folder = std::filesystem::u8path(this->Folder / "inner");
  std::filesystem::create_directory(folder);
  WriteFile((folder / "image.raw").u8string(), SampleBytes<std::uint16_t>(60, false));
  this->ExpectVolume(Replaced(Header, "image.raw", "inner/image.raw"));
  this->ExpectVolume(Replaced(Header, "image.raw", "inner/../image.raw"));
  for (const std::string& name : { std::string("../image.raw"), std::string("../inner2/image.raw"),
         this->Folder / "image.raw", std::string("x/../../image.raw"), std::string("/image.raw") })
  {
    const std::string header = (folder / "header.mhd").u8string();
    WriteFile(header, Replaced(Header, "image.raw", name));
    std::string error;
    EXPECT_FALSE(OpenMetaImage(header, error)) << name;
    ExpectSentence(error, "header's folder");
  }
}
