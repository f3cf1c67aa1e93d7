// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include "Program/Quoted.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MostPreamble = 136; // bytes, up to the word that tells that it is DICOM

using Tag = std::uint32_t; // group and element

constexpr Tag TransferSyntax = 0x00020010, Interpretation = 0x00280004, Rows = 0x00280010,
              Columns = 0x00280011, Bits = 0x00280100, Pixels = 0x7fe00010, Series = 0x0020000e,
              Position = 0x00200032, Orientation = 0x00200037, Offset = 0x00281052,
              Slope = 0x00281053, Number = 0x00200013, Location = 0x00201041;

// What VTK's parser looks into, without looking whether it is there: text, and 16 bits.
const std::set<Tag> Texts = { 0x00100010, 0x00180050, 0x00181120, TransferSyntax, 0x0020000d,
  Series, 0x00200010, Number, Position, Orientation, Location, Interpretation, 0x00280030, Offset,
  Slope };
const std::set<Tag> Words = { Rows, Columns, Bits, 0x00280103 };

// What slices of one volume have in common.
struct Slice
{
  unsigned Rows = 0, Columns = 0, Bits = 0;
  double Components = 1.0, Bytes = 0.0;
  double Slope = 1.0, Offset = 0.0; // of values
  std::set<Tag> Found;
  std::set<std::string> Series; // several in an index of others

  // VTK's reader makes these floats.
  bool HasFractions() const
  {
    return std::floor(this->Slope) != this->Slope || std::floor(this->Offset) != this->Offset;
  }

  bool IsLike(const Slice& other) const
  {
    return this->Rows == other.Rows && this->Columns == other.Columns && this->Bits == other.Bits &&
      this->Components == other.Components && this->HasFractions() == other.HasFractions();
  }
};

// Goes through a file as VTK's parser does: through sequences as if what is in them stood alone.
class Walk
{
public:
  explicit Walk(const std::string& path)
    : Path(path)
    , Bytes(BytesOf(path, MostPreamble))
  {
  }

  // False if the file is no DICOM, and nobody reads it.
  bool Find(Slice& slice)
  {
    if (this->Bytes.compare(0, 4, "DICM") == 0)
    {
      this->At = 4;
    }
    else if (this->Bytes.size() > 132 && this->Bytes.compare(128, 4, "DICM") == 0)
    {
      this->At = 132;
    }
    else
    {
      return false;
    }
    this->Bytes = BytesOf(this->Path);
    while (this->At < this->Bytes.size())
    {
      this->Take(slice);
    }
    return true;
  }

private:
  unsigned NumberAt(std::size_t at, std::size_t bytes) const
  {
    unsigned number = 0;
    for (std::size_t i = bytes; i-- > 0;)
    {
      number = number << 8 | static_cast<unsigned char>(this->Bytes[at + i]);
    }
    return number;
  }

  void Require(std::size_t bytes) const
  {
    if (bytes > this->Bytes.size() - this->At)
    {
      throw Damaged(this->Path, "it ends within an element");
    }
  }

  // Length of what is at At, behind the tag; At is then where it begins.
  unsigned Length()
  {
    static const std::set<std::string> shorts = { "AW", "AE", "AS", "CS", "UI", "DA", "DS", "DT",
      "IS", "LO", "LT", "PN", "ST", "TM", "UT", "SH", "FL", "SL", "AT", "UL", "US", "SS", "FD" };
    static const std::set<std::string> longs = { "OB", "OW", "UN", "SQ" };
    const std::string kind = this->Bytes.substr(this->At, 2);
    if (longs.count(kind) == 1)
    {
      this->Require(8);
      this->At += 8;
      return this->NumberAt(this->At - 4, 4);
    }
    this->At += 4;
    return shorts.count(kind) == 1 ? this->NumberAt(this->At - 2, 2)
                                   : this->NumberAt(this->At - 4, 4);
  }

  void Take(Slice& slice)
  {
    this->Require(8);
    const Tag tag = this->NumberAt(this->At, 2) << 16 | this->NumberAt(this->At + 2, 2);
    this->At += 4;
    const unsigned length = this->Length();
    const bool isText = Texts.count(tag) == 1, isWord = Words.count(tag) == 1;
    if (length > 0x7fffffffu && !isText && !isWord && tag != Pixels)
    {
      return; // a sequence of any length: what is in it comes next
    }
    this->Require(length);
    if ((isText && length == 0) || (isWord && length < 2) || (tag == Pixels && this->HasPixels))
    {
      throw Damaged(this->Path, "it has an element of another length than it should");
    }
    this->Keep(tag, length, slice);
    this->At += length;
  }

  void Keep(Tag tag, unsigned length, Slice& slice)
  {
    slice.Found.insert(tag);
    const std::string text =
      Texts.count(tag) == 1 ? std::string(this->Bytes.substr(this->At, length).c_str()) : "";
    if (Words.count(tag) == 1)
    {
      const unsigned number = this->NumberAt(this->At, 2);
      slice.Rows = tag == Rows ? number : slice.Rows;
      slice.Columns = tag == Columns ? number : slice.Columns;
      slice.Bits = tag == Bits ? number : slice.Bits;
    }
    else if (tag == TransferSyntax && text != "1.2.840.10008.1.2" && text != "1.2.840.10008.1.2.1")
    {
      throw Damaged(this->Path,
        "its transfer syntax is " + Quoted(text) +
          ", which is not read here; convert it to one in little endian without compression");
    }
    else if (tag == Series)
    {
      slice.Series.insert(text);
    }
    else if (tag == Interpretation)
    {
      slice.Components = text == "RGB " ? 3.0 : 1.0;
    }
    else if (tag == Position || tag == Orientation || tag == Slope || tag == Offset)
    {
      const double first = this->FirstNumber(text);
      slice.Slope = tag == Slope ? first : slice.Slope;
      slice.Offset = tag == Offset ? first : slice.Offset;
    }
    else if (tag == Pixels)
    {
      slice.Bytes = length;
      this->HasPixels = true;
    }
  }

  // Slices are sorted by such numbers, which has to be possible.
  double FirstNumber(const std::string& text) const
  {
    std::istringstream in(text);
    std::string word;
    double first = 0.0;
    for (bool isFirst = true; std::getline(in, word, '\\'); isFirst = false)
    {
      const float number = std::strtof(word.c_str(), nullptr);
      if (!(std::abs(number) <= 1e9f))
      {
        throw Damaged(this->Path, "it has the numbers " + Quoted(text));
      }
      first = isFirst ? static_cast<double>(number) : first;
    }
    return first;
  }

  const std::string& Path;
  std::string Bytes;
  std::size_t At = 0;
  bool HasPixels = false;
};

// A slice of the series that is read.
void CheckSlice(const std::string& path, const Slice& slice)
{
  for (const Tag tag : { Pixels, Rows, Columns, Bits, Interpretation })
  {
    if (slice.Found.count(tag) == 0)
    {
      throw UserError(Quoted(path) +
        " belongs to the first DICOM series of the directory, which is the one that is read, but "
        "it "
        "has no pixels, or does not tell what they are; move what is no slice elsewhere.");
    }
  }
  const double pixels = static_cast<double>(slice.Rows) * slice.Columns * slice.Components;
  if ((slice.Bits != 8 && slice.Bits != 16) || pixels < 1.0)
  {
    throw Damaged(path,
      "it has " + std::to_string(slice.Columns) + " x " + std::to_string(slice.Rows) +
        " pixels of " + std::to_string(slice.Bits) + " bits");
  }
  RequireSamples(path, pixels, slice.Bits / 8.0, slice.Bytes);
}

// Of another series, whose numbers VTK's parser keeps if it comes last: they must not make another
// volume of the slices. Reports tell of none of them.
bool IsHarmless(const Slice& other, const Slice& first)
{
  const auto isLike = [&other](Tag tag, bool isEqual)
  { return other.Found.count(tag) == 0 || isEqual; };
  return isLike(Rows, other.Rows == first.Rows) &&
    isLike(Columns, other.Columns == first.Columns) && isLike(Bits, other.Bits == first.Bits) &&
    isLike(Interpretation, other.Components == first.Components) &&
    isLike(Slope, other.HasFractions() == first.HasFractions()) &&
    isLike(Offset, other.HasFractions() == first.HasFractions());
}

}

void CheckDicomFiles(const std::string& directory)
{
  std::map<std::string, Slice> slices; // by path
  std::set<std::string> series;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error))
  {
    const std::string path = entry.path().string();
    if (entry.is_directory(error))
    {
      continue;
    }
    SizeOf(path); // throws if it is no regular file, which the reader would open, too
    Slice slice;
    if (Walk(path).Find(slice))
    {
      series.insert(slice.Series.begin(), slice.Series.end());
      slices.emplace(path, slice);
    }
  }
  // VTK's reader takes the first series.
  const Slice* first = nullptr;
  bool hasOrder = false;
  for (const auto& [path, slice] : slices)
  {
    if (!series.empty() && slice.Series.count(*series.begin()) == 1)
    {
      CheckSlice(path, slice);
      if (first && !slice.IsLike(*first))
      {
        throw Damaged(path, "its slice is of another kind than others of the directory");
      }
      first = &slice;
      for (const Tag tag : { Number, Location, Position, Orientation })
      {
        hasOrder = hasOrder || slice.Found.count(tag) == 1;
      }
    }
  }
  // Without an order it takes all files.
  if (!slices.empty() && (!first || !hasOrder))
  {
    throw Damaged(slices.begin()->first, "it tells of no series, or of no place in it");
  }
  for (const auto& [path, slice] : slices)
  {
    if (first && !IsHarmless(slice, *first))
    {
      throw UserError(Quoted(path) +
        " is of another DICOM series than the one that is read, and of another kind; move it "
        "elsewhere.");
    }
  }
}
