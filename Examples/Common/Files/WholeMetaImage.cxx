// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/WholeCheck.h"

#include "Files/FileCheck.h"
#include "Files/Reading.h"
#include "Program/Quoted.h"

#include <vtkNew.h>
#include <vtkType.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <sstream>

namespace
{

namespace fs = std::filesystem;
using Fields = std::map<std::string, std::string>;

std::vector<double> NumbersOf(const std::string& text)
{
  std::istringstream in(text);
  std::vector<double> numbers;
  for (double number = 0.0; in >> number;)
  {
    numbers.push_back(number);
  }
  return numbers;
}

double NumberOf(Fields& fields, const char* key, double otherwise)
{
  const std::vector<double> numbers = NumbersOf(fields[key]);
  return numbers.empty() ? otherwise : numbers.front();
}

// As MetaIO reads it.
bool IsTrue(Fields& fields, const char* key, bool otherwise)
{
  const std::string& text = fields[key];
  return text.empty() ? otherwise : text[0] == 'T' || text[0] == 't' || text[0] == '1';
}

double BytesOfType(const std::string& type)
{
  const std::map<std::string, double> bytes = { { "CHAR", 1 }, { "SHORT", 2 }, { "INT", 4 },
    { "FLOAT", 4 }, { "DOUBLE", 8 } };
  const std::size_t begin = type.compare(0, 5, "MET_U") == 0 ? 5 : 4;
  const auto found = bytes.find(type.substr(begin, type.find('_', begin) - begin));
  return found == bytes.end() ? 1.0 : found->second;
}

// Where the samples of a file lie, and what its header tells of them.
struct Samples
{
  std::string Path;
  double Begin = 0.0; // of the samples in the file
  double Count = 0.0; // of all channels
  double Bytes = 0.0; // that they have in memory
};

std::string BytesFrom(const Samples& samples, double most)
{
  std::ifstream file(samples.Path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(samples.Begin));
  const double rest = static_cast<double>(SizeOf(samples.Path)) - samples.Begin;
  std::string bytes(static_cast<std::size_t>(std::max(0.0, std::min(rest, most))), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

// MetaIO is content with whatever comes out of a compressed file.
bool HasAllCompressed(const Samples& samples, Fields& fields)
{
  // Without a size, or with 0, it is all of the file.
  const double size = NumberOf(fields, "CompressedDataSize", 0.0);
  const bool isLocal = LowerCase(fields["ElementDataFile"]) == "local";
  if (isLocal && size <= 0.0)
  {
    return false;
  }
  const std::string bytes = BytesFrom(samples, size > 0.0 ? size : VTK_DOUBLE_MAX);
  if (bytes.compare(0, 2, "\x1f\x8b") == 0) // gzip ends with the size
  {
    std::uint32_t told = 0;
    for (std::size_t i = 0; i < 4 && bytes.size() > 18; ++i)
    {
      told |= std::uint32_t(static_cast<unsigned char>(bytes[bytes.size() - 4 + i])) << 8 * i;
    }
    return told == static_cast<std::uint32_t>(static_cast<std::uint64_t>(samples.Bytes));
  }
  std::vector<unsigned char> room(static_cast<std::size_t>(samples.Bytes));
  vtkNew<vtkZLibDataCompressor> zlib;
  return zlib->Uncompress(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
           room.data(), room.size()) == room.size();
}

bool HasAllText(const Samples& samples)
{
  std::ifstream file(samples.Path);
  file.seekg(static_cast<std::streamoff>(samples.Begin));
  double count = 0.0, number = 0.0;
  while (count < samples.Count && file >> number)
  {
    ++count;
  }
  return count >= samples.Count;
}

// MetaIO reads as many slices as are listed.
void RequireSlices(const std::string& path, const std::string& words, double endOfHeader,
  const std::vector<double>& dimensions)
{
  std::istringstream in(words);
  std::string pattern;
  in >> pattern;
  const std::vector<double> numbers = NumbersOf(words.substr(pattern.size()));
  double wanted = dimensions.back(), listed = wanted;
  if (pattern == "LIST")
  {
    double of = numbers.empty() ? 0.0 : numbers[0];
    of = of < 1.0 || of > static_cast<double>(dimensions.size())
      ? static_cast<double>(dimensions.size()) - 1.0
      : of;
    wanted = std::accumulate(dimensions.begin() + static_cast<std::ptrdiff_t>(of), dimensions.end(),
      1.0, std::multiplies<>());
    std::ifstream file(path);
    file.seekg(static_cast<std::streamoff>(endOfHeader));
    listed = 0.0;
    for (std::string line; std::getline(file, line) && !file.eof();)
    {
      listed += line.empty() ? 0.0 : 1.0;
    }
  }
  else if (numbers.size() > 1)
  {
    const double step = numbers.size() > 2 ? std::max(numbers[2], 1.0)
                                           : std::max((numbers[1] - numbers[0]) / wanted, 1.0);
    listed = std::floor((numbers[1] - numbers[0]) / std::floor(step)) + 1.0;
  }
  if (listed < wanted)
  {
    std::ostringstream what;
    what << "it names " << listed << " slices, but its DimSize tells of " << wanted;
    throw Damaged(path, what.str());
  }
}

double EndOfHeader(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);)
  {
    if (line.compare(0, 15, "ElementDataFile") == 0)
    {
      break;
    }
  }
  return static_cast<double>(file.tellg());
}

void RequireConsistent(const std::string& path, Fields& fields, double endOfHeader)
{
  const std::vector<double> dimensions = NumbersOf(fields["DimSize"]);
  const double channels = NumberOf(fields, "ElementNumberOfChannels", 1.0);
  const double headerSize = NumberOf(fields, "HeaderSize", 0.0);
  const bool isLocal = LowerCase(fields["ElementDataFile"]) == "local";
  const bool isBinary = IsTrue(fields, "BinaryData", true);
  const bool isMsb = IsTrue(fields, "BinaryDataByteOrderMSB", false);
  const struct
  {
    bool IsSo;
    const char* What;
  } contradictions[] = {
    { fields["ElementDataFile"].empty(), "its header names no file of samples" },
    { dimensions.empty() ||
        NumberOf(fields, "NDims", 0.0) != static_cast<double>(dimensions.size()),
      "NDims is not how many numbers DimSize has" },
    { channels < 1.0 ||
        std::any_of(dimensions.begin(), dimensions.end(), [](double n) { return n < 1.0; }),
      "DimSize or ElementNumberOfChannels is less than 1" },
    { headerSize < -1.0 || (isLocal && headerSize > 0.0 && headerSize < endOfHeader),
      "HeaderSize is not where its samples begin" },
    { !fields["BinaryDataByteOrderMSB"].empty() &&
        IsTrue(fields, "ElementByteOrderMSB", isMsb) != isMsb,
      "ElementByteOrderMSB contradicts BinaryDataByteOrderMSB" },
    { !isBinary && channels > 1.0, "VTK does not read several channels as text" },
  };
  for (const auto& contradiction : contradictions)
  {
    if (contradiction.IsSo)
    {
      throw Damaged(path, contradiction.What);
    }
  }
}

// Where MetaIO finds the samples.
std::string FileOfSamples(const std::string& path, const std::string& name)
{
  const std::string file = (fs::path(path).parent_path() / name).string();
  std::error_code error;
  for (const char* suffix : { "", ".gz", ".Z" })
  {
    if (fs::is_regular_file(file + suffix, error))
    {
      return file + suffix;
    }
  }
  throw UserError(Quoted(path) + " names the file " + Quoted(file) +
    ", which is not there; put it there, or correct the name.");
}

}

std::string RequireWholeMetaImage(const std::string& path, Fields fields)
{
  const double endOfHeader = EndOfHeader(path);
  RequireConsistent(path, fields, endOfHeader);
  const std::vector<double> dimensions = NumbersOf(fields["DimSize"]);
  const std::string name = fields["ElementDataFile"];
  if (name.compare(0, 4, "LIST") == 0 || name.find('%') != std::string::npos)
  {
    RequireSlices(path, name, endOfHeader, dimensions);
    return "";
  }
  const bool isLocal = LowerCase(name) == "local", isBinary = IsTrue(fields, "BinaryData", true);
  const double headerSize = NumberOf(fields, "HeaderSize", 0.0);
  Samples samples;
  samples.Path = isLocal ? path : FileOfSamples(path, name);
  // With a size of -1 they lie at the end, but behind a header in the same file.
  samples.Begin = headerSize > 0.0 ? headerSize : isLocal ? endOfHeader : 0.0;
  samples.Count = std::accumulate(dimensions.begin(), dimensions.end(),
    NumberOf(fields, "ElementNumberOfChannels", 1.0), std::multiplies<>());
  samples.Bytes = samples.Count * BytesOfType(fields["ElementType"]);
  RequireBytesFor(path, samples.Bytes);
  const double there = static_cast<double>(SizeOf(samples.Path));
  const double more = there - samples.Bytes - samples.Begin;
  const bool isCompressed = (isBinary && IsTrue(fields, "CompressedData", false)) ||
    (!isLocal && fs::path(samples.Path).filename() != fs::path(name).filename());
  const bool isWhole = isCompressed ? HasAllCompressed(samples, fields)
    : isBinary                      ? more >= 0.0
                                    : HasAllText(samples);
  if (!isWhole)
  {
    throw Damaged(path, Quoted(samples.Path) + " has fewer samples than the header tells of");
  }
  std::ostringstream remark;
  if (isBinary && !isCompressed && headerSize >= 0.0 && more > 0.0)
  {
    remark << Quoted(samples.Path) << " has " << more
           << " bytes more than its header tells of, which are not drawn; check DimSize and "
              "ElementType.";
  }
  return remark.str();
}
