// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/DicomSlice.h"

#include "Files/FileCheck.h"
#include "Program/Quoted.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <sstream>

namespace
{

constexpr std::size_t Preamble = 128; // bytes before the word DICM; some files have none

using Tag = std::uint32_t; // group and element

constexpr Tag TransferSyntax = 0x00020010, Interpretation = 0x00280004, Rows = 0x00280010,
              Columns = 0x00280011, PixelSpacing = 0x00280030, Bits = 0x00280100,
              Pixels = 0x7fe00010, Series = 0x0020000e, Position = 0x00200032,
              Orientation = 0x00200037, EndOfItem = 0xfffee00d, EndOfSequence = 0xfffee0dd;
constexpr unsigned OpenEnd = 0xffffffffu; // the length of a sequence that an element ends

// Numbers of a text, between backslashes; none if one of them is none.
std::vector<double> NumbersOf(const std::string& text)
{
  std::vector<double> numbers;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, '\\');)
  {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || !(std::abs(numbers.back()) <= 1e9))
    {
      return {};
    }
  }
  return numbers;
}

class Walk
{
public:
  Walk(const std::string& bytes, std::size_t begin, DicomSlice& slice)
    : Bytes(bytes)
    , At(begin)
    , Slice(slice)
  {
  }

  void Run()
  {
    while (this->At + 8 <= this->Bytes.size())
    {
      this->Take();
    }
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

  // Length of what is at At, behind the tag; At is then where it begins.
  unsigned Length(bool isDelimiter)
  {
    static const std::set<std::string> shorts = { "AE", "AS", "AT", "CS", "DA", "DS", "DT", "FD",
      "FL", "IS", "LO", "LT", "PN", "SH", "SL", "SS", "ST", "TM", "UI", "UL", "US" };
    static const std::set<std::string> longs = { "OB", "OD", "OF", "OL", "OV", "OW", "SQ", "SV",
      "UC", "UN", "UR", "UT", "UV" };
    const std::string kind = this->Bytes.substr(this->At, 2);
    if (!isDelimiter && longs.count(kind) == 1 && this->At + 8 <= this->Bytes.size())
    {
      this->At += 8;
      return this->NumberAt(this->At - 4, 4);
    }
    this->At += 4;
    return !isDelimiter && shorts.count(kind) == 1 ? this->NumberAt(this->At - 2, 2)
                                                   : this->NumberAt(this->At - 4, 4);
  }

  void Take()
  {
    const Tag tag = this->NumberAt(this->At, 2) << 16 | this->NumberAt(this->At + 2, 2);
    this->At += 4;
    const unsigned length = this->Length(tag >> 16 == 0xfffe);
    if (length == OpenEnd)
    {
      ++this->Depth; // what is in it comes next
      return;
    }
    this->Depth -= (tag == EndOfItem || tag == EndOfSequence) && this->Depth > 0 ? 1 : 0;
    if (length > this->Bytes.size() - this->At)
    {
      throw Damaged(this->Slice.Path, "it ends within an element");
    }
    if (this->Depth == 0)
    {
      this->Keep(tag, length);
    }
    this->At += length;
  }

  void Keep(Tag tag, unsigned length)
  {
    const auto text = [&] { return std::string(this->Bytes.substr(this->At, length).c_str()); };
    const unsigned number = length >= 2 ? this->NumberAt(this->At, 2) : 0;
    switch (tag)
    {
      case TransferSyntax:
        this->RequireKnown(text());
        break;
      case Series:
        this->Slice.Series = text();
        break;
      case Interpretation:
        this->Slice.Components = text().compare(0, 3, "RGB") == 0 ? 3.0 : 1.0;
        break;
      case Rows:
        this->Slice.Rows = number;
        break;
      case Columns:
        this->Slice.Columns = number;
        break;
      case PixelSpacing:
        this->Slice.Spacing = NumbersOf(text());
        if (this->Slice.Spacing.size() != 2 || !(this->Slice.Spacing[0] > 0.0) ||
          !(this->Slice.Spacing[1] > 0.0))
        {
          this->Slice.Spacing.clear();
        }
        break;
      case Bits:
        this->Slice.Bits = number;
        break;
      case Position:
        if (const std::vector<double> numbers = NumbersOf(text()); numbers.size() == 3)
        {
          this->Slice.Position = vtkVector3d(numbers.data());
        }
        break;
      case Orientation:
        this->Slice.Orientation = NumbersOf(text());
        this->Slice.Orientation.resize(this->Slice.Orientation.size() == 6 ? 6 : 0);
        break;
      case Pixels:
        this->Slice.Bytes = length;
        break;
      default:
        break;
    }
  }

  void RequireKnown(const std::string& syntax) const
  {
    if (syntax != "1.2.840.10008.1.2" && syntax != "1.2.840.10008.1.2.1")
    {
      throw Damaged(this->Slice.Path,
        "its transfer syntax is " + Quoted(syntax) +
          ", which is not read here; convert it to one in little endian without compression");
    }
  }

  const std::string& Bytes;
  std::size_t At;
  DicomSlice& Slice;
  int Depth = 0; // of sequences
};

}

std::optional<DicomSlice> ReadDicomHeader(const std::string& path)
{
  const std::string start = BytesOf(path, Preamble + 4);
  const bool isBare = start.compare(0, 4, "DICM") == 0;
  if (!isBare && (start.size() < Preamble + 4 || start.compare(Preamble, 4, "DICM") != 0))
  {
    return {};
  }
  DicomSlice slice;
  slice.Path = path;
  const std::string bytes = BytesOf(path);
  Walk(bytes, isBare ? 4 : Preamble + 4, slice).Run();
  if (slice.HasPixels())
  {
    const double wanted = static_cast<double>(slice.Rows) * slice.Columns * slice.Components *
      std::ceil(slice.Bits / 8.0);
    if (slice.Bytes >= 2.0 * wanted && wanted > 0.0)
    {
      throw Damaged(path, "it has several frames, which are not read here; convert it to slices");
    }
    if ((slice.Bits != 8 && slice.Bits != 16) || slice.Bytes < wanted)
    {
      throw Damaged(path,
        "its " + std::to_string(slice.Columns) + " x " + std::to_string(slice.Rows) +
          " pixels of " + std::to_string(slice.Bits) + " bits are not there");
    }
  }
  return slice;
}
