// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include "Files/Reading.h"
#include "Files/StackFiles.h"
#include "Program/Quoted.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace
{

namespace fs = std::filesystem;

// How many bytes one byte of a file can become. zlib tells 1032 as its maximum, runs of SLC have at
// most 127; LZMA, which VTK's XML may be compressed by, has no bound.
struct Inflation
{
  const char* Suffix;
  double Most;
};
constexpr Inflation Inflations[] = { { ".gz", 1032.0 }, { ".mha", 1032.0 }, { ".mhd", 1032.0 },
  { ".png", 1032.0 }, { ".nrrd", 1032.0 }, { ".nhdr", 1032.0 }, { ".cgns", 1032.0 },
  { ".ex2", 1032.0 }, { ".exo", 1032.0 }, { ".e", 1032.0 }, { ".slc", 127.0 }, { ".vtk", 1.0 },
  { ".nii", 1.0 }, { "xyz", 1.0 }, { "xyz.bin", 1.0 }, { ".dcm", 1032.0 } };
constexpr double InflationOfXml = 8192.0;

constexpr double Wider = 8.0;                   // bytes of a number that a digit of text becomes
constexpr double Copies = 2.0;                  // of what is read, for a while
constexpr double LeastBytes = 512 << 20;        // of memory
constexpr double LeastSeconds = 1.5;            // small files take a hundredth of a second
constexpr double BytesPerSecond = 4 << 20;      // that a slow machine reads, at least, and
constexpr double InflatedPerSecond = 128 << 20; // that it inflates
constexpr std::size_t MostOfList = 1 << 20;     // bytes that are searched for names of files

double InflationOf(const std::string& path)
{
  std::error_code error;
  const std::string name = fs::is_directory(path, error) ? ".dcm" : LowerCase(path);
  const auto* found = std::find_if(std::begin(Inflations), std::end(Inflations),
    [&name](const Inflation& inflation) { return EndsWith(name, inflation.Suffix); });
  return found == std::end(Inflations) ? InflationOfXml : found->Most;
}

double BytesOfFolder(const fs::path& folder)
{
  double sum = 0.0;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
  {
    sum += entry.is_regular_file(error) ? static_cast<double>(entry.file_size(error)) : 0.0;
  }
  return sum;
}

// What may be names of files in a text: words, and the ends of lines, where names may have spaces.
std::set<std::string> NamesIn(const std::string& text)
{
  constexpr std::size_t Longest = 1024;
  std::set<std::string> names;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t end = std::min(text.find_first_of("\"'=<> \t\r\n", at), text.size());
    if (end > at && end - at < Longest)
    {
      names.insert(text.substr(at, end - at));
    }
    at = end + 1;
  }
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
  {
    const std::size_t colon = line.find(": "), begin = colon == std::string::npos ? 0 : colon + 2;
    const std::size_t end = line.find_last_not_of(" \t\r") + 1;
    if (begin < end && end - begin < Longest)
    {
      names.insert(line.substr(begin, end - begin));
    }
  }
  return names;
}

}

UserError Damaged(const std::string& path, const std::string& reason)
{
  return UserError(Quoted(path) + " could not be read: " + reason +
    "; check that the file is whole and of the right format.");
}

UserError TooLarge(const std::string& path)
{
  return UserError(Quoted(path) +
    " takes more memory than there is; check that the file is whole, or choose a smaller one.");
}

std::uintmax_t SizeOf(const std::string& path)
{
  std::error_code error;
  // Others may never end, or never begin.
  if (!fs::is_regular_file(path, error))
  {
    throw Damaged(path, fs::exists(path, error) ? "it is no regular file" : "it is not there");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

std::string BytesOf(const std::string& path, std::uintmax_t most)
{
  std::string bytes(static_cast<std::size_t>(std::min(SizeOf(path), most)), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) && !bytes.empty())
  {
    throw Damaged(path, "it could not be read to its end");
  }
  return bytes;
}

double BytesWithParts(const std::string& path)
{
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (fs::is_directory(path, error))
  {
    return BytesOfFolder(path);
  }
  const std::string name = LowerCase(path);
  const bool isOfList = EndsWith(name, ".mhd") || EndsWith(name, ".nhdr") ||
    EndsWith(name, ".nrrd") || EndsWith(name, ".vtm") || EndsWith(name, ".vtmb") ||
    EndsWith(name, ".vth") || EndsWith(name, ".vthb") || name.find(".pvt") != std::string::npos;
  if (IsPictureName(path))
  {
    double sum = 0.0;
    for (const std::string& slice : StackFilesOf(path).Paths)
    {
      const std::uintmax_t size = fs::file_size(slice, error);
      sum += error ? 0.0 : static_cast<double>(size);
    }
    return sum;
  }
  double sum = static_cast<double>(SizeOf(path));
  if (EndsWith(name, "xyz") || EndsWith(name, "xyz.bin"))
  {
    return BytesOfFolder(folder); // one of them has the values
  }
  if (isOfList)
  {
    std::string text = BytesOf(path, MostOfList);
    const bool hasSamples = EndsWith(name, ".nrrd"); // after an empty line
    text.resize(std::min({ text.size(), hasSamples ? text.find("\n\n") : text.size(),
      hasSamples ? text.find("\r\n\r\n") : text.size() }));
    for (const std::string& word : NamesIn(text))
    {
      // A pattern of names stands for several.
      sum += word.find('%') != std::string::npos ? BytesOfFolder(folder) : 0.0;
      const fs::path part = folder / word;
      sum +=
        fs::is_regular_file(part, error) ? static_cast<double>(fs::file_size(part, error)) : 0.0;
    }
  }
  return sum;
}

ReadingLimits LimitsOf(const std::string& path)
{
  const double bytes = BytesWithParts(path), inflated = bytes * InflationOf(path);
  return { LeastSeconds + bytes / BytesPerSecond + inflated / InflatedPerSecond,
    LeastBytes + Copies * Wider * inflated };
}

void RequireBytesFor(const std::string& path, double bytes)
{
  constexpr double Few = 1 << 20; // for what has no samples
  if (bytes > Few + Wider * BytesWithParts(path) * InflationOf(path))
  {
    throw Damaged(path, "its header tells of more samples than it can hold");
  }
}
