// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include "Program/Quoted.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <climits>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace
{

constexpr double LeastShare = 4096.0;       // of an extent that pieces hold, as 1 in so many
constexpr std::size_t MostHeader = 1 << 24; // bytes of a file that are searched for elements

const std::map<std::string, double> BytesOfType = { { "Int8", 1.0 }, { "UInt8", 1.0 },
  { "Int16", 2.0 }, { "UInt16", 2.0 }, { "Int32", 4.0 }, { "UInt32", 4.0 }, { "Int64", 8.0 },
  { "UInt64", 8.0 }, { "Float32", 4.0 }, { "Float64", 8.0 }, { "Bit", 0.125 }, { "String", 0.0 } };

// How many bytes one byte can become; of LZMA it is not bounded.
const std::map<std::string, double> Compressors = { { "", 1.0 },
  { "vtkZLibDataCompressor", MostByDeflation }, { "vtkLZ4DataCompressor", 256.0 },
  { "vtkLZMADataCompressor", 1e5 } };

// What files may hold: a grid, or a list of files with parts of one.
const std::set<std::string> Types = { "ImageData", "RectilinearGrid", "StructuredGrid",
  "UnstructuredGrid", "PRectilinearGrid", "PStructuredGrid", "PUnstructuredGrid",
  "vtkMultiBlockDataSet", "vtkOverlappingAMR", "vtkHierarchicalBoxDataSet" };

// The name and the attributes of an element, and where its content begins.
struct Element
{
  std::string Name;
  std::map<std::string, std::string> Attributes;
  std::size_t End = 0;

  std::string operator[](const std::string& name) const
  {
    const auto attribute = this->Attributes.find(name);
    return attribute == this->Attributes.end() ? "" : attribute->second;
  }
};

// Finds elements one after the other; what is no XML is left to the parser.
class Elements
{
public:
  explicit Elements(const std::string& text)
    : Text(text)
  {
  }

  bool Next(Element& element)
  {
    const std::size_t begin = this->Text.find('<', this->At);
    const std::size_t end = this->EndOf(begin);
    if (end == std::string::npos)
    {
      return false;
    }
    element = {};
    element.End = this->At = end + 1;
    std::size_t at = begin + 1;
    while (at < end && !std::isspace(static_cast<unsigned char>(this->Text[at])))
    {
      element.Name += this->Text[at++];
    }
    while (true)
    {
      const std::size_t equals = this->Text.find('=', at);
      const std::size_t quote = this->Text.find_first_of("\"'", equals);
      if (quote >= end)
      {
        return true;
      }
      const std::size_t close = this->Text.find(this->Text[quote], quote + 1);
      std::istringstream name(this->Text.substr(at, equals - at));
      std::string key;
      name >> key;
      element.Attributes[key] = this->Text.substr(quote + 1, close - quote - 1);
      at = close == std::string::npos ? end : close + 1;
    }
  }

private:
  // The first > that is no part of an attribute.
  std::size_t EndOf(std::size_t begin) const
  {
    std::size_t at = this->Text.find_first_of("\"'>", begin);
    while (at != std::string::npos && this->Text[at] != '>')
    {
      at = this->Text.find(this->Text[at], at + 1);
      at = at == std::string::npos ? at : this->Text.find_first_of("\"'>", at + 1);
    }
    return at;
  }

  const std::string& Text;
  std::size_t At = 0;
};

// Bytes that are written as such, or in base 64.
std::string Decoded(const std::string& text, std::size_t at, std::size_t count, bool isRaw)
{
  if (isRaw)
  {
    return at < text.size() ? text.substr(at, count) : "";
  }
  static const std::string digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, value = 0;
  for (; at < text.size() && bytes.size() < count; ++at)
  {
    const std::size_t digit = digits.find(text[at]);
    if (digit == std::string::npos)
    {
      break;
    }
    value = (value << 6 | static_cast<unsigned>(digit)) & 0xffffffu;
    bits += 6;
    if (bits >= 8)
    {
      bits -= 8;
      bytes += static_cast<char>(value >> bits & 0xffu);
    }
  }
  return bytes;
}

class Check
{
public:
  explicit Check(const std::string& path)
    : Path(path)
    , Text(BytesOf(path, MostHeader))
    , Size(static_cast<double>(SizeOf(path)))
  {
  }

  void Run()
  {
    const std::size_t appended = this->Text.find("<AppendedData");
    if (appended != std::string::npos)
    {
      this->Begin = this->Text.find('_', this->Text.find('>', appended));
      const std::size_t raw = this->Text.find("raw", appended);
      this->IsRaw = raw < this->Text.find('>', appended);
    }
    const std::string markup = this->Text.substr(0, appended);
    Elements elements(markup);
    for (Element element; elements.Next(element);)
    {
      this->Visit(element);
    }
    // Of a part of a distributed image it may be little.
    if (this->WholePoints > LeastShare * this->PiecePoints)
    {
      throw Damaged(this->Path, "its pieces hold next to nothing of its extent");
    }
  }

private:
  void Visit(const Element& element)
  {
    const std::string& name = element.Name;
    if (name == "VTKFile")
    {
      this->LookAtFile(element);
    }
    else if (name == "ImageData" || name == "StructuredGrid" || name == "RectilinearGrid")
    {
      this->PointsOf(element["WholeExtent"]);
      this->WholePoints = this->Points;
    }
    else if (name == "Piece")
    {
      if (element.Attributes.count("NumberOfPoints") == 1)
      {
        this->PointsOfMesh(element);
      }
      else if (element.Attributes.count("Source") == 0)
      {
        this->PointsOf(element["Extent"]);
        this->PiecePoints += this->Points;
      }
    }
    else if (name == "PointData" || name == "CellData" || name == "FieldData" || name == "Points" ||
      name == "Cells" || name == "Coordinates")
    {
      this->Place = name;
    }
    else if (name == "DataArray" || name == "Array")
    {
      this->LookAtArray(element);
    }
  }

  void LookAtFile(const Element& element)
  {
    const std::string header = element["header_type"], order = element["byte_order"];
    this->Compressor = element["compressor"];
    const bool isKnown = (header.empty() || header == "UInt32" || header == "UInt64") &&
      (order.empty() || order == "LittleEndian" || order == "BigEndian") &&
      Compressors.count(this->Compressor) == 1;
    if (!isKnown || Types.count(element["type"]) == 0)
    {
      throw Damaged(this->Path, "its element VTKFile is not that of an image or a grid");
    }
    this->HeaderSize = header == "UInt64" ? 8 : 4;
    this->IsBig = order == "BigEndian";
  }

  void PointsOf(const std::string& extent)
  {
    std::istringstream in(extent);
    std::array<long long, 6> ends{};
    std::string word;
    for (long long& end : ends)
    {
      if (!(in >> word) || !IsWhole(word, INT_MIN / 2, INT_MAX / 2, end))
      {
        throw Damaged(this->Path, "it has the extent " + Quoted(extent));
      }
    }
    this->Points = this->Cells = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto steps = static_cast<double>(ends[2 * axis + 1] - ends[2 * axis]);
      this->Points *= std::max(steps + 1.0, 0.0);
      this->Cells *= std::max(steps, 1.0);
    }
    // Bits of samples that are nearly all the same.
    RequireSamples(this->Path, this->Points, 0.125, this->Size, Compressors.at(this->Compressor));
  }

  void PointsOfMesh(const Element& element)
  {
    long long points = 0, cells = 0;
    if (!IsWhole(element["NumberOfPoints"], 0, LLONG_MAX, points) ||
      !IsWhole(element["NumberOfCells"], 0, LLONG_MAX, cells))
    {
      throw Damaged(this->Path, "its numbers of points and cells are no numbers");
    }
    this->Points = static_cast<double>(points);
    this->Cells = static_cast<double>(cells);
    const double most = std::max(this->Points, this->Cells);
    RequireSamples(this->Path, most, 1.0, this->Size, Compressors.at(this->Compressor));
  }

  void LookAtArray(const Element& element)
  {
    long long components = 1, tuples = 0, offset = 0;
    const auto type = BytesOfType.find(element["type"]);
    if (type == BytesOfType.end() ||
      !this->IsCount(element, "NumberOfComponents", 1, 1000, components) ||
      !this->IsCount(element, "NumberOfTuples", 0, LLONG_MAX, tuples) ||
      !this->IsCount(element, "offset", 0, LLONG_MAX, offset))
    {
      throw Damaged(this->Path,
        "its array " + Quoted(element["Name"]) +
          " has a type, components, tuples or an offset that there are not");
    }
    if (this->Place == "Cells" || this->Place == "Coordinates")
    {
      return; // how many there are, only other arrays tell
    }
    const double count = this->Place == "FieldData" ? static_cast<double>(tuples)
      : this->Place == "CellData"                   ? this->Cells
                                                    : this->Points;
    const double values = count * static_cast<double>(components);
    // As VTK's reader has it: what is neither appended nor binary is text.
    const bool isInline =
      element["format"] != "appended" && element.Attributes.count("offset") == 0;
    const bool isText = isInline && element["format"] != "binary";
    const bool isCompressed = !this->Compressor.empty() && !isText;
    RequireSamples(this->Path, values, isText ? 1.0 : type->second, this->Size,
      isCompressed ? Compressors.at(this->Compressor) : 1.0);
    if (isText || type->first == "String")
    {
      return;
    }
    std::size_t at = element.End;
    if (!isInline)
    {
      if (this->Begin == std::string::npos || static_cast<double>(offset) > this->Size)
      {
        throw Damaged(this->Path, "its appended data are not there");
      }
      at = this->Begin + 1 + static_cast<std::size_t>(offset);
    }
    while (isInline && at < this->Text.size() &&
      std::isspace(static_cast<unsigned char>(this->Text[at])))
    {
      ++at;
    }
    this->LookAtSizes(at, !isInline && this->IsRaw, std::ceil(values * type->second));
  }

  // How many bytes an array has, in blocks if it is compressed, as it says before them.
  void LookAtSizes(std::size_t at, bool isRaw, double wanted)
  {
    const std::size_t most = this->Compressor.empty() ? 1 : 3;
    const std::size_t needed = most * this->HeaderSize;
    const std::size_t characters = isRaw ? needed : (needed + 2) / 3 * 4;
    if (at + characters > this->Text.size() && static_cast<double>(this->Text.size()) < this->Size)
    {
      return; // behind what is looked at
    }
    const std::string bytes = Decoded(this->Text, at, needed, isRaw);
    if (bytes.size() < needed && wanted > 0.0)
    {
      // Without blocks there are no sizes of them.
      throw Damaged(this->Path, "it ends before the size of an array");
    }
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < most && wanted > 0.0; ++i)
    {
      numbers[i] = this->NumberAt(bytes, i);
    }
    const double blocks = numbers[0], size = numbers[1], last = numbers[2];
    const double there = this->Compressor.empty() ? blocks
      : last > 0.0                                ? (blocks - 1.0) * size + last
                                                  : blocks * size;
    const bool areBlocks = this->Compressor.empty() ||
      (blocks >= 1.0 && size >= 1.0 && last <= size &&
        blocks * static_cast<double>(this->HeaderSize) <= this->Size);
    // Whole values: readers count them by division.
    if (wanted > 0.0 && (!areBlocks || there != wanted))
    {
      std::ostringstream what;
      what.precision(15);
      what << "an array of it should have " << wanted << " bytes, but has " << there;
      throw Damaged(this->Path, what.str());
    }
    if (wanted > 0.0 && !this->Compressor.empty())
    {
      this->LookAtBlocks(at, isRaw, static_cast<std::size_t>(blocks));
    }
  }

  void LookAtBlocks(std::size_t at, bool isRaw, std::size_t blocks)
  {
    const std::string bytes = Decoded(this->Text, at, (blocks + 3) * this->HeaderSize, isRaw);
    double sum = 0.0;
    for (std::size_t block = 3; (block + 1) * this->HeaderSize <= bytes.size(); ++block)
    {
      sum += this->NumberAt(bytes, block);
    }
    if (sum > this->Size)
    {
      throw Damaged(this->Path, "its compressed blocks are larger than it is");
    }
  }

  // Of those that precede an array.
  double NumberAt(const std::string& bytes, std::size_t i) const
  {
    double number = 0.0;
    for (std::size_t j = 0; j < this->HeaderSize; ++j)
    {
      const std::size_t place = this->IsBig ? j : this->HeaderSize - 1 - j;
      number = 256.0 * number + static_cast<unsigned char>(bytes[i * this->HeaderSize + place]);
    }
    return number;
  }

  bool IsCount(const Element& element, const char* name, long long least, long long most,
    long long& count) const
  {
    const std::string text = element[name];
    return text.empty() ? element.Attributes.count(name) == 0 : IsWhole(text, least, most, count);
  }

  const std::string& Path;
  const std::string Text;
  const double Size;
  std::size_t Begin = std::string::npos; // of appended data: the mark before them
  bool IsRaw = false;
  bool IsBig = false;
  std::size_t HeaderSize = 4; // bytes of a size
  std::string Compressor, Place;
  double Points = 0.0, Cells = 0.0; // of the piece that is looked at
  double WholePoints = 0.0, PiecePoints = 0.0;
};

}

void CheckXmlFile(const std::string& path)
{
  Check(path).Run();
}
