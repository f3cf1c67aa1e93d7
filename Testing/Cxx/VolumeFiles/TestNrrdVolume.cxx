// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// NRRD files, with samples inside or beside them, are read in all types and variants. Mistakes
// become sentences.

#include "HeaderFiles.h"

#include "VolumeFiles/NrrdVolume.h"

using namespace TemporalCoherence;

namespace
{

const char* const Header = "NRRD0004\n# a comment\ntype: unsigned short\ndimension: 3\n"
                           "space: left-posterior-superior\nsizes: 5 4 3\n"
                           "space directions: (0.5,0,0) (0,1,0) (0,0,2)\n"
                           "kinds: domain domain domain\nendian: little\nencoding: raw\n"
                           "space origin: (1,2,3)\nauthor:=someone\n";

class NrrdVolume : public testing::Test
{
protected:
  std::unique_ptr<VolumeFile> Open(const std::string& text, std::string& error) const
  {
    WriteFile(this->Folder / "image.nrrd", text);
    return OpenNrrd(this->Folder / "image.nrrd", error);
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
    const std::string data = '\n' + SampleBytes<std::uint16_t>(60, false);
    EXPECT_FALSE(this->Open(Replaced(Header, part, by) + data, error)) << by;
    ExpectSentence(error, "image.nrrd");
  }

  const ScratchFolder Folder;
};

}

TEST_F(NrrdVolume, ReadsAllTypes)
{
  const char* const names[] = { "signed char", "uint8_t", "short", "unsigned short int", "int",
    "uint32", "long long", "uint64_t", "float", "double" };
  for (int number = 0; number < 10; ++number)
  {
    DispatchScalarType(static_cast<ScalarType>(number),
      [&](auto zero)
      {
        using T = decltype(zero);
        for (const bool bigEndian : { false, true })
        {
          std::string text = Replaced(Header, "unsigned short", names[number]);
          text = Replaced(text, "endian: little", bigEndian ? "Endian: big" : "endian: little");
          std::string error;
          const auto file = this->Open(text + '\n' + SampleBytes<T>(60, bigEndian), error);
          ASSERT_TRUE(file) << error;
          EXPECT_EQ(file->Type(), static_cast<ScalarType>(number));
          ExpectSamples<T>(*file);
        }
      });
  }
}

TEST_F(NrrdVolume, ReadsVariants)
{
  const std::string bytes = SampleBytes<std::uint16_t>(60, false);
  this->ExpectVolume(std::string(Header) + '\n' + bytes);
  this->ExpectVolume(std::string(Header) + "\r\n" + bytes);
  this->ExpectVolume(std::string(Header) + "byte skip: 3\n\nabc" + bytes);
  this->ExpectVolume(std::string(Header) + "byteskip: -1\n\nabcdefgh" + bytes);
  const std::string spacings =
    Replaced(Header, "space directions: (0.5,0,0) (0,1,0) (0,0,2)", "spacings: 0.5 NaN 2");
  this->ExpectVolume(spacings + '\n' + bytes);
  WriteFile(this->Folder / "image.raw", "1234" + bytes);
  this->ExpectVolume(std::string(Header) + "data file: image.raw\nbyte skip: 4\n");
  this->ExpectVolume(std::string(Header) + "datafile: ./image.raw\nbyteskip: -1");
}

TEST_F(NrrdVolume, TellsMistakes)
{
  this->ExpectErrorWith("NRRD0004", "NRRD");
  this->ExpectErrorWith("unsigned short", "long");
  this->ExpectErrorWith("unsigned short", "block");
  this->ExpectErrorWith("dimension: 3", "dimension: 4");
  this->ExpectErrorWith("encoding: raw", "encoding: gzip");
  this->ExpectErrorWith("endian: little", "");
  this->ExpectErrorWith("kinds: domain", "kinds: vector");
  this->ExpectErrorWith("sizes: 5", "sizes: 0");
  this->ExpectErrorWith("sizes: 5 4 3", "sizes: 5 4");
  this->ExpectErrorWith("sizes: 5 4 3", "sizes: 5 4 4");
  this->ExpectErrorWith("sizes: 5", "sizes: 2147483648");
  this->ExpectErrorWith("sizes: 5 4 3", "sizes: 2147483647 2147483647 2147483647");
  this->ExpectErrorWith("(0.5,0,0)", "(-0.5,0,0)");
  this->ExpectErrorWith("(0.5,0,0)", "(0,0.5,0)");
  this->ExpectErrorWith("(0.5,0,0)", "none");
  this->ExpectErrorWith("(0.5,0,0)", "(0.5,0.1,0)");
  this->ExpectErrorWith("(0.5,0,0)", "(nan,0,0)");
  this->ExpectErrorWith("(1,2,3)", "(1,2)");
  this->ExpectErrorWith("author:=", "line skip: 2\n");
  this->ExpectErrorWith("author:=someone", "byte skip: -2");
  this->ExpectErrorWith("author:=someone", "byte skip: 9223372036854775807");
  this->ExpectErrorWith("author:=someone", "data file: ../image.raw");
  this->ExpectErrorWith("author:=someone", "data file: /etc/image.raw");
  this->ExpectErrorWith("author:=someone", "data file:");
  this->ExpectErrorWith("author:=someone", "data file: LIST");
  this->ExpectErrorWith("author:=someone", "data file: image%03d.raw 1 3 1");
}
