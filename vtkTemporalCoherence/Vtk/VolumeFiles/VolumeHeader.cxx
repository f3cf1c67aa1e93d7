// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/VolumeHeader.h"

#include "VolumeFiles/RandomAccessFile.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <limits>
#include <locale>
#include <memory>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

constexpr std::uint64_t MostBytesOfHeader = std::uint64_t(1) << 20;

/// Read exactly `count` numbers of any type.
template <typename Number>
bool Parse(const std::string& text, std::size_t count, Number* numbers)
{
  std::istringstream reader(text);
  reader.imbue(std::locale::classic());
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!(reader >> numbers[i]))
    {
      return false;
    }
  }
  std::string rest;
  return !(reader >> rest);
}

/// The path of a file by the name in a header.
/// \return false if it does not lie in the header's folder or below
bool PathInFolder(const std::string& header, const std::string& name, std::string& path)
{
  namespace fs = std::filesystem;
  try
  {
    const fs::path folder = fs::absolute(fs::u8path(header)).lexically_normal().parent_path();
    const fs::path data = (folder / fs::u8path(name)).lexically_normal();
    const fs::path inFolder = data.lexically_relative(folder);
    path = data.u8string();
    return !inFolder.empty() && inFolder != "." && *inFolder.begin() != "..";
  }
  catch (const std::exception&) // the name is no correct UTF-8, for example
  {
    return false;
  }
}

}

bool ReadHeader(const std::string& path, HeaderText& header, std::string& error)
{
  const std::unique_ptr<RandomAccessFile> file = RandomAccessFile::Open(path, error);
  if (!file)
  {
    return false;
  }
  header.Path = path;
  header.Text.resize(static_cast<std::size_t>(std::min(file->Size(), MostBytesOfHeader)));
  return file->Read(0, header.Text.data(), header.Text.size(), error);
}

std::string HeaderError(const std::string& path, const std::string& what, const std::string& remedy)
{
  return "Cannot use '" + path + "': " + what + "; " + remedy + '.';
}

std::string Trimmed(const std::string& text)
{
  const char* const spaces = " \t\r\n";
  const std::size_t first = text.find_first_not_of(spaces);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

std::string LowerCase(std::string text)
{
  for (char& letter : text)
  {
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return text;
}

bool NextLine(const std::string& text, std::size_t& position, std::string& line)
{
  if (position >= text.size())
  {
    return false;
  }
  const std::size_t end = std::min(text.find('\n', position), text.size());
  line = Trimmed(text.substr(position, end - position));
  position = std::min(end + 1, text.size());
  return true;
}

bool ParseNumbers(const std::string& text, std::size_t count, double* numbers)
{
  return Parse(text, count, numbers);
}

bool ParseIntegers(const std::string& text, std::size_t count, std::int64_t* numbers)
{
  return Parse(text, count, numbers);
}

bool ParseDimensions(const std::string& text, glm::ivec3& dimensions)
{
  std::int64_t numbers[3];
  if (!ParseIntegers(text, 3, numbers))
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (numbers[axis] < 1 || numbers[axis] > std::numeric_limits<int>::max())
    {
      return false;
    }
    dimensions[axis] = static_cast<int>(numbers[axis]);
  }
  return true;
}

bool IsIdentity(const double* matrix)
{
  constexpr double rounding = 1e-6;
  for (int i = 0; i < 9; ++i)
  {
    if (!(std::abs(matrix[i] - (i % 4 == 0 ? 1.0 : 0.0)) <= rounding))
    {
      return false;
    }
  }
  return true;
}

bool FindDataFile(
  const HeaderText& header, const std::string& name, std::string& path, std::string& error)
{
  if (!name.empty() && name.find('\0') == std::string::npos &&
    PathInFolder(header.Path, name, path))
  {
    return true;
  }
  error =
    HeaderError(header.Path, "its data file '" + name + "' does not lie in the header's folder",
      "move the data file there and correct the header");
  return false;
}

bool FindOffsetFromEnd(const std::string& path, RawLayout& layout, std::string& error)
{
  std::uint64_t bytes = 0;
  if (!CheckLayout(path, layout, error) || !BytesOf(layout.Dimensions, layout.Type, bytes))
  {
    return false;
  }
  const std::unique_ptr<RandomAccessFile> file = RandomAccessFile::Open(path, error);
  if (!file)
  {
    return false;
  }
  // OpenRaw() tells of a file that is too small.
  layout.Offset = file->Size() - std::min(file->Size(), bytes);
  return true;
}

}
