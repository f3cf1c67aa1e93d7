// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include "Files/Reading.h"
#include "Program/Quoted.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

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
  { ".cgns", 1032.0 }, { ".ex2", 1032.0 }, { ".exo", 1032.0 }, { ".e", 1032.0 }, { ".slc", 127.0 },
  { ".vtk", 1.0 }, { ".nii", 1.0 }, { "xyz", 1.0 }, { "xyz.bin", 1.0 }, { ".dcm", 1032.0 } };
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

// Words of a text that may be names of files.
std::vector<std::string> WordsOf(const std::string& text)
{
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t end = std::min(text.find_first_of("\"'=<> \t\r\n", at), text.size());
    if (end > at && end - at < 1024)
    {
      words.push_back(text.substr(at, end - at));
    }
    at = end + 1;
  }
  return words;
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
  const bool isOfList = EndsWith(name, ".mhd") || EndsWith(name, ".vtm") ||
    EndsWith(name, ".vtmb") || EndsWith(name, ".vth") || EndsWith(name, ".vthb") ||
    name.find(".pvt") != std::string::npos;
  double sum = static_cast<double>(SizeOf(path));
  if (EndsWith(name, "xyz") || EndsWith(name, "xyz.bin"))
  {
    return BytesOfFolder(folder); // one of them has the values
  }
  if (isOfList)
  {
    const std::string text = BytesOf(path, MostOfList);
    for (const std::string& word : WordsOf(text))
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
