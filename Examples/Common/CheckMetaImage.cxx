// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileCheck.h"

#include "Quoted.h"

#include <algorithm>
#include <climits>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MostHeader = 1 << 16; // bytes
constexpr std::size_t MostValue = 200;      // characters of a value; MetaIO copies them into 255

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
    while (std::getline(in, line))
    {
      this->Rest.push_back(Trimmed(line));
    }
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

  double End = 0.0;              // where the samples of a file of one's own begin
  std::vector<std::string> Rest; // the first lines after the header

private:
  void Take(const std::string& line)
  {
    const std::size_t equals = line.find('=');
    const std::string key = Trimmed(line.substr(0, equals));
    const bool isEmpty = Trimmed(line).empty();
    const std::string value = equals == std::string::npos ? "" : Trimmed(line.substr(equals + 1));
    const bool isText = value.find_first_not_of("0123456789+-.eE \t") != std::string::npos;
    if ((!isEmpty && equals == std::string::npos) || (isText && value.size() > MostValue) ||
      value.size() > 2 * MostValue || Printable(key) != key || key.size() > MostValue)
    {
      throw Damaged(this->Path, "its header has the line " + Quoted(line));
    }
    if (!isEmpty && !this->Fields.emplace(key, value).second)
    {
      throw Damaged(this->Path, "its header has two lines " + Quoted(key));
    }
  }

  const std::string& Path;
  std::map<std::string, std::string> Fields;
};

double SizeOfAll(const std::vector<std::string>& names, const fs::path& directory)
{
  double size = 0.0;
  for (const std::string& name : names)
  {
    size += static_cast<double>(SizeOf((directory / name).string()));
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
  const fs::path directory = fs::path(path).parent_path();
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
    std::vector<std::string> names;
    std::copy_if(header.Rest.begin(), header.Rest.end(), std::back_inserter(names),
      [](const std::string& name) { return !name.empty(); });
    return SizeOfAll(names, directory);
  }
  if (file.find('%') != std::string::npos)
  {
    return SizeOfAll(Numbered(path, words), directory);
  }
  return SizeOfAll({ file }, directory);
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
  const auto type = BytesOfType.find(header.Text("ElementType"));
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
