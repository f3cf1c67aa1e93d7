// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Headers with random changes are read, or refused with a sentence. Nothing crashes, and what can
// be opened can be read.

#include "HeaderFiles.h"
#include "Mutations.h"

#include "VolumeFiles/MetaImageVolume.h"
#include "VolumeFiles/NrrdVolume.h"
#include "VolumeFiles/VtiVolume.h"

#include <functional>
#include <random>

using namespace TemporalCoherence;

namespace
{

constexpr int UsualMutations = 3000; // of each header

/// Words and numbers that headers treat specially.
const char* const Words[] = { "-1", "0", "2147483647", "2147483648", "9223372036854775807",
  "18446744073709551616", "1e308", "nan", "inf", "LOCAL", "LIST", "..", "/", "\n", "\n\n", "=", ":",
  "\"", "<", ">", "_", "&a;", "<!--", "<AppendedData", "<Piece>", "%d", "True", "raw" };

class Mutator
{
public:
  explicit Mutator(unsigned int seed)
    : Random(seed)
  {
  }

  /// Change, delete, repeat or insert one to four parts.
  /// \param end of the part to change
  std::string operator()(std::string text, std::size_t end)
  {
    for (std::size_t changes = 1 + this->Below(4); changes > 0; --changes)
    {
      end = std::min(end, text.size());
      const std::size_t place = this->Below(end + 1);
      const std::size_t length = std::min(this->Below(12), text.size() - place);
      switch (this->Below(5))
      {
        case 0:
          text.replace(place, std::min<std::size_t>(1, text.size() - place), 1,
            static_cast<char>(this->Below(256)));
          break;
        case 1:
          text.erase(place, length);
          break;
        case 2:
          text.insert(place, text.substr(this->Below(end + 1), length));
          break;
        case 3:
          text.replace(place, length, Words[this->Below(std::size(Words))]);
          break;
        default:
          text.resize(this->Below(8) == 0 ? place : text.size());
      }
    }
    return text;
  }

private:
  std::size_t Below(std::size_t count)
  {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(this->Random);
  }

  std::mt19937 Random;
};

using OpenFile = std::function<std::unique_ptr<VolumeFile>(const std::string&, std::string&)>;

/// Open files with mistakes. Those that can be opened must be readable, or tell why not.
void OpenMutations(
  const std::string& path, const std::string& text, std::size_t end, const OpenFile& open)
{
  int opened = 0;
  for (int i = 0; i < NumberOfMutations(UsualMutations); ++i)
  {
    WriteFile(path, Mutator(static_cast<unsigned int>(i))(text, end));
    std::string error;
    const std::unique_ptr<VolumeFile> file = open(path, error);
    if (!file)
    {
      ASSERT_FALSE(error.empty()) << i;
      ASSERT_EQ(error.back(), '.') << i << error;
      continue;
    }
    ++opened;
    const VolumeLevel& level = file->Levels().front();
    std::vector<char> samples(level.SamplesOfChunk() * SizeOf(file->Type()));
    const glm::ivec3 last = level.NumberOfChunks() - 1;
    ASSERT_TRUE(file->ReadChunk(0, { 0, 0, 0 }, samples.data(), error)) << i << error;
    ASSERT_TRUE(file->ReadChunk(0, last, samples.data(), error)) << i << error;
    ASSERT_FALSE(file->HasFailed(error));
  }
  EXPECT_GT(opened, 0);
  EXPECT_LT(opened, NumberOfMutations(UsualMutations));
}

}

TEST(MutatedHeaders, Vti)
{
  const ScratchFolder folder;
  const std::string path = folder / "image.vti";
  WriteVti(path, MakeImage(ScalarType::UInt16), [](vtkXMLWriter*) {});
  const std::string text = ReadFile(path);
  OpenMutations(path, text, text.find("   _") + 8,
    [](const std::string& name, std::string& error) { return OpenVti(name, "", error); });
}

TEST(MutatedHeaders, MetaImage)
{
  const ScratchFolder folder;
  for (const char* name : { "image.mha", "image.mhd" })
  {
    WriteMetaImage(folder / name, MakeImage(ScalarType::Float32));
    const std::string text = ReadFile(folder / name);
    OpenMutations(folder / name, text, text.find("ElementDataFile") + 24, OpenMetaImage);
  }
}

TEST(MutatedHeaders, Nrrd)
{
  const ScratchFolder folder;
  const std::string text = "NRRD0004\ntype: uint16\ndimension: 3\nsizes: 5 4 3\n"
                           "space directions: (0.5,0,0) (0,1,0) (0,0,2)\nendian: little\n"
                           "encoding: raw\nspace origin: (1,2,3)\n";
  const std::string bytes = SampleBytes<std::uint16_t>(60, false);
  OpenMutations(folder / "in.nrrd", text + "byte skip: 0\n\n" + bytes, text.size() + 15, OpenNrrd);
  WriteFile(folder / "image.raw", bytes);
  OpenMutations(folder / "out.nhdr", text + "data file: image.raw\n", text.size() + 21, OpenNrrd);
}
