// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include <cctype>
#include <climits>

namespace
{

// Reads as vtkSLCReader does, by scanf.
class Scanner
{
public:
  explicit Scanner(const std::string& path)
    : Path(path)
    , Bytes(BytesOf(path))
  {
  }

  // A word of text, and what is white before it.
  std::string Word()
  {
    this->SkipWhite();
    const std::size_t begin = this->At;
    while (this->At < this->Bytes.size() && !this->IsWhite())
    {
      ++this->At;
    }
    return this->Bytes.substr(begin, this->At - begin);
  }

  long long Whole(long long least, long long most)
  {
    long long number = 0;
    if (!IsWhole(this->Word(), least, most, number))
    {
      throw Damaged(this->Path, "its header has something else where a number should be");
    }
    return number;
  }

  void SkipX()
  {
    this->SkipWhite();
    if (this->At == this->Bytes.size() || this->Bytes[this->At++] != 'X')
    {
      throw Damaged(this->Path, "there is no X where bytes should begin");
    }
  }

  void SkipWhite()
  {
    while (this->At < this->Bytes.size() && this->IsWhite())
    {
      ++this->At;
    }
  }

  std::string Take(double count)
  {
    RequireSamples(this->Path, count, 1.0, static_cast<double>(this->Bytes.size() - this->At));
    this->At += static_cast<std::size_t>(count);
    return this->Bytes.substr(
      this->At - static_cast<std::size_t>(count), static_cast<std::size_t>(count));
  }

private:
  bool IsWhite() const { return std::isspace(static_cast<unsigned char>(this->Bytes[this->At])); }

  const std::string& Path;
  std::string Bytes;
  std::size_t At = 0;
};

// How many bytes runs become; nothing where the last run has no end. A run is its length, with the
// highest bit set if its bytes follow, else with the one byte that is repeated. 0 ends them.
double Decoded(const std::string& runs)
{
  double count = 0.0;
  for (std::size_t at = 0; at < runs.size();)
  {
    const auto run = static_cast<unsigned char>(runs[at]);
    const std::size_t length = run & 0x7fu;
    if (length == 0)
    {
      return count;
    }
    count += static_cast<double>(length);
    at += 1 + ((run & 0x80u) != 0 ? length : 1);
  }
  return -1.0;
}

}

void CheckSlc(const std::string& path)
{
  Scanner scanner(path);
  scanner.Whole(11111, 11111);
  long long size[3];
  for (long long& n : size)
  {
    n = scanner.Whole(1, INT_MAX);
  }
  const double plane = static_cast<double>(size[0]) * static_cast<double>(size[1]);
  if (plane > INT_MAX)
  {
    throw Damaged(path, "its slices are too large");
  }
  scanner.Whole(0, INT_MAX); // bits of a sample
  for (int i = 0; i < 3; ++i)
  {
    scanner.Word(); // spacing
  }
  for (int i = 0; i < 3; ++i)
  {
    scanner.Whole(INT_MIN, INT_MAX); // unit, origin, modification
  }
  const bool isCompressed = scanner.Whole(0, 1) == 1;
  const auto width = static_cast<double>(scanner.Whole(0, 65535));
  const auto height = static_cast<double>(scanner.Whole(0, 65535));
  scanner.SkipX();
  if (width * height < 1.0 || width * height > INT_MAX)
  {
    throw Damaged(path, "its icon has no pixels, or too many");
  }
  scanner.Take(3.0 * width * height);
  if (!isCompressed)
  {
    scanner.Take(plane * static_cast<double>(size[2]));
    return;
  }
  for (long long slice = 0; slice < size[2]; ++slice)
  {
    const auto bytes = static_cast<double>(scanner.Whole(1, INT_MAX));
    scanner.SkipX();
    if (Decoded(scanner.Take(bytes)) != plane)
    {
      throw Damaged(path, "slice " + std::to_string(slice) + " has other samples than it should");
    }
  }
}
