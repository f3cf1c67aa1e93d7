// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include "Program/Quoted.h"

#include <algorithm>
#include <climits>
#include <cstdio>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MostHeader = 1 << 16; // bytes
constexpr std::size_t MostValue = 200;      // characters of a text that MetaIO copies into 255
constexpr std::size_t MostLine = 400;       // of any value that MetaIO knows; it has room for 500
constexpr std::size_t MostUnknown = 32000;  // of other values, which MetaIO keeps in 32768

// The fields that MetaIO knows.
const std::set<std::string> Texts = { "AcquisitionDate", "AnatomicalOrientation", "BinaryData",
  "BinaryDataByteOrderMSB", "Comment", "CompressedData", "DistanceUnits", "ElementByteOrderMSB",
  "ElementDataFile", "ElementType", "Modality", "Name", "ObjectSubType", "ObjectType" };
const std::set<std::string> Numbers = { "CenterOfRotation", "Color", "CompressedDataSize",
  "DimSize", "ElementDirection", "ElementMax", "ElementMin", "ElementNBits",
  "ElementNumberOfChannels", "ElementOrigin", "ElementSize", "ElementSpacing",
  "ElementToIntensityFunctionOffset", "ElementToIntensityFunctionSlope", "FileFormatVersion",
  "HeaderSize", "ID", "ImagePosition", "NDims", "Offset", "Orientation", "Origin", "ParentID",
  "Position", "Rotation", "SequenceID", "TransformMatrix" };

const std::map<std::string, double> BytesOfType = { { "MET_CHAR", 1.0 }, { "MET_UCHAR", 1.0 },
  { "MET_SHORT", 2.0 }, { "MET_USHORT", 2.0 }, { "MET_INT", 4.0 }, { "MET_UINT", 4.0 },
  { "MET_LONG", 4.0 }, { "MET_ULONG", 4.0 }, { "MET_LONG_LONG", 8.0 }, { "MET_ULONG_LONG", 8.0 },
  { "MET_FLOAT", 4.0 }, { "MET_DOUBLE", 8.0 } };

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  const std::size_t end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::vector<std::string> WordsOf(const std::string& text)
{
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;)
  {
    words.push_back(word);
  }
  return words;
}

class Header
{
public:
  explicit Header(const std::string& path)
    : Path(path)
  {
    std::istringstream in(BytesOf(path, MostHeader));
    std::string line;
    while (this->Fields.count("ElementDataFile") == 0 && std::getline(in, line))
    {
      this->Take(line);
    }
    if (this->Fields.count("ElementDataFile") == 0)
    {
      throw Damaged(path, "its header has no line ElementDataFile");
    }
    this->End = in.good() ? static_cast<double>(in.tellg()) : static_cast<double>(SizeOf(path));
  }

  const std::string& Text(const std::string& key) const
  {
    static const std::string none;
    const auto field = this->Fields.find(key);
    return field == this->Fields.end() ? none : field->second;
  }

  long long Whole(const std::string& key, long long least, long long most, long long missing) const
  {
    long long number = missing;
    const std::string& text = this->Text(key);
    if (!text.empty() && !IsWhole(text, least, most, number))
    {
      throw Damaged(this->Path, "its line " + key + " is " + Quoted(text));
    }
    return number;
  }

  double End = 0.0; // where the samples of a file of one's own begin, or a list of files

private:
  void Take(const std::string& line)
  {
    const std::size_t equals = line.find_first_of("=:"); // MetaIO takes both
    const std::string key = Trimmed(line.substr(0, equals));
    const bool isEmpty = Trimmed(line).empty();
    const std::size_t begin = line.find_first_not_of("=: \t", equals);
    const std::string value = begin == std::string::npos ? "" : Trimmed(line.substr(begin));
    const bool isKnown = Texts.count(key) == 1 || Numbers.count(key) == 1;
    const bool isText =
      Texts.count(key) == 1 && value.find_first_not_of("0123456789+-.eE \t") != std::string::npos;
    const std::size_t most = isText ? MostValue : isKnown ? MostLine : MostUnknown;
    if ((!isEmpty && equals == std::string::npos) || value.size() > most || Printable(key) != key ||
      key.size() > MostValue)
    {
      throw Damaged(this->Path, "its header has the line " + Quoted(line));
    }
    if (!isEmpty && !this->Fields.emplace(key, value).second && isKnown)
    {
      throw Damaged(this->Path, "its header has two lines " + Quoted(key));
    }
  }

  const std::string& Path;
  std::map<std::string, std::string> Fields;
};

// Of the files of samples that a header names.
double SizeOfAll(const std::vector<std::string>& names, const std::string& header)
{
  double size = 0.0;
  for (const std::string& name : names)
  {
    const fs::path path = fs::path(header).parent_path() / name;
    std::error_code error;
    if (!fs::is_regular_file(path, error))
    {
      throw Damaged(header, "its file of samples " + Quoted(name) + " is not there");
    }
    size += static_cast<double>(SizeOf(path.string()));
  }
  return size;
}

// Files with a number in their names: "slice%03d.raw 1 20 1".
std::vector<std::string> Numbered(const std::string& path, const std::vector<std::string>& words)
{
  long long first = 0, last = 0, step = 1;
  // The pattern goes to printf.
  if (words.size() != 4 || !std::regex_match(words[0], std::regex("[^%]*%0?[0-9]{0,2}d[^%]*")) ||
    !IsWhole(words[1], 0, 999999, first) || !IsWhole(words[2], first, 999999, last) ||
    !IsWhole(words[3], 1, 999999, step))
  {
    throw Damaged(path, "its line ElementDataFile tells of no row of files");
  }
  std::vector<std::string> names;
  for (long long number = first; number <= last; number += step)
  {
    std::string name(words[0].size() + 100, '\0');
    const int length =
      std::snprintf(name.data(), name.size(), words[0].c_str(), static_cast<int>(number));
    names.push_back(name.substr(0, static_cast<std::size_t>(std::max(length, 0))));
  }
  return names;
}

// Bytes that may hold samples.
double BytesThere(const std::string& path, const Header& header)
{
  const std::string& file = header.Text("ElementDataFile");
  const std::vector<std::string> words = WordsOf(file);
  if (words.empty())
  {
    throw Damaged(path, "its line ElementDataFile names no file");
  }
  if (words[0] == "LOCAL" || words[0] == "Local" || words[0] == "local")
  {
    return std::max(static_cast<double>(SizeOf(path)) - header.End, 0.0);
  }
  if (words[0].compare(0, 4, "LIST") == 0)
  {
    std::istringstream in(BytesOf(path).substr(static_cast<std::size_t>(header.End)));
    std::vector<std::string> names;
    for (std::string line; std::getline(in, line);)
    {
      if (!Trimmed(line).empty())
      {
        names.push_back(Trimmed(line));
      }
    }
    return SizeOfAll(names, path);
  }
  if (file.find('%') != std::string::npos)
  {
    return SizeOfAll(Numbered(path, words), path);
  }
  return SizeOfAll({ file }, path);
}

}

void CheckMetaImage(const std::string& path)
{
  const Header header(path);
  // Without the third axis VTK's reader takes what is next in memory, with a fourth it writes
  // there.
  const long long axes = header.Whole("NDims", 2, 3, -1);
  const std::vector<std::string> sizes = WordsOf(header.Text("DimSize"));
  double samples = static_cast<double>(header.Whole("ElementNumberOfChannels", 1, 1000, 1));
  long long number = 0;
  for (const std::string& size : sizes)
  {
    samples *= IsWhole(size, 1, INT_MAX, number) ? static_cast<double>(number) : -1.0;
    if (samples < 0.0)
    {
      break;
    }
  }
  if (axes < 0 || samples < 0.0 || sizes.size() != static_cast<std::size_t>(axes))
  {
    throw Damaged(path,
      "its header tells of " + Quoted(header.Text("NDims")) + " axes with " +
        Quoted(header.Text("DimSize")) + " samples");
  }
  const std::string& said = header.Text("ElementType");
  const auto type = BytesOfType.find(said.substr(0, said.rfind("_ARRAY")));
  if (type == BytesOfType.end())
  {
    throw Damaged(path, "its samples are " + Quoted(header.Text("ElementType")));
  }
  const std::string& compressed = header.Text("CompressedData");
  const bool isCompressed =
    !compressed.empty() && (compressed[0] == 'T' || compressed[0] == 't' || compressed[0] == '1');
  const double there = BytesThere(path, header);
  header.Whole("HeaderSize", -1, static_cast<long long>(std::min(there, 1e15)), 0);
  header.Whole("CompressedDataSize", 0, static_cast<long long>(std::min(there, 1e15)), 0);
  const std::string& binary = header.Text("BinaryData");
  const bool isText = !binary.empty() && (binary[0] == 'F' || binary[0] == 'f' || binary[0] == '0');
  RequireSamples(
    path, samples, isText ? 1.0 : type->second, there, isCompressed ? MostByDeflation : 1.0);
}
