// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include "Files/Reading.h"
#include "Program/Quoted.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace
{

constexpr std::size_t MostHeader = 4096; // bytes, up to the dimensions
constexpr std::size_t MostLine = 255;    // characters, as VTK's reader has it

const std::map<std::string, double> BytesOfType = { { "bit", 0.125 }, { "char", 1.0 },
  { "signed_char", 1.0 }, { "unsigned_char", 1.0 }, { "short", 2.0 }, { "unsigned_short", 2.0 },
  { "int", 4.0 }, { "unsigned_int", 4.0 }, { "vtkidtype", 4.0 }, { "long", 8.0 },
  { "unsigned_long", 8.0 }, { "vtktypeint64", 8.0 }, { "vtktypeuint64", 8.0 }, { "float", 4.0 },
  { "double", 8.0 } };

const std::set<std::string> Kinds = { "structured_points", "structured_grid", "rectilinear_grid",
  "unstructured_grid" };
const std::map<std::string, std::string> Refused = { { "polydata", "vtkPolyData" },
  { "field", "vtkDataObject" } };

// The arrays that follow the word FIELD: the reader takes their sizes without asking whether they
// are numbers.
void CheckField(const std::string& path, std::streamoff at, bool isBinary, double there)
{
  std::ifstream in(path, std::ios::binary);
  in.seekg(at);
  const auto next = [&in]
  {
    std::string word;
    in.width(256);
    in >> word;
    return word;
  };
  next();
  next(); // its name
  long long arrays = 0, components = 0, tuples = 0;
  if (!IsWhole(next(), 0, static_cast<long long>(there), arrays))
  {
    throw Damaged(path, "it tells of no number of arrays in FIELD");
  }
  std::string name = next();
  for (long long i = 0; i < arrays; ++i)
  {
    if (name == "METADATA")
    {
      std::string line;
      std::getline(in, line); // that word's own
      while (std::getline(in, line) && !line.empty())
      {
      }
      name = next();
    }
    if (name != "NULL_ARRAY")
    {
      if (!IsWhole(next(), 0, 100000, components) || !IsWhole(next(), 0, LLONG_MAX, tuples) ||
        static_cast<double>(components) * static_cast<double>(tuples) > 8.0 * there)
      {
        throw Damaged(path, "it tells of no sizes of an array in FIELD");
      }
      const auto bytes = BytesOfType.find(LowerCase(next()));
      if (bytes == BytesOfType.end())
      {
        return; // of strings only the reader knows how many bytes they have
      }
      const long long values = components * tuples;
      if (isBinary)
      {
        std::string line;
        std::getline(in, line);
        in.seekg(
          static_cast<std::streamoff>(std::ceil(static_cast<double>(values) * bytes->second)),
          std::ios::cur);
      }
      for (long long value = 0; !isBinary && value < values && in; ++value)
      {
        next();
      }
    }
    name = next();
  }
}

// The table's name belongs to SCALARS: samples follow it, not the size of a table.
bool IsOfScalars(const std::string& before)
{
  std::istringstream in(before);
  std::vector<std::string> words;
  for (std::string word; in >> word;)
  {
    words.push_back(LowerCase(word));
  }
  // A name, a type, and maybe a number of components stand between.
  const std::size_t count = words.size();
  return (count >= 3 && words[count - 3] == "scalars") ||
    (count >= 4 && words[count - 4] == "scalars");
}

// Keywords by which words there is a number by which VTK's reader takes memory, or begins anew so
// often.
const std::map<std::string, int> Counted = { { "CELLS", 0 }, { "CELL_TYPES", 0 }, { "FIELD", 1 },
  { "INFORMATION", 0 }, { "LOOKUP_TABLE", 1 }, { "POINTS", 0 }, { "SCALARS", 2 },
  { "COLOR_SCALARS", 1 }, { "TEXTURE_COORDINATES", 1 }, { "X_COORDINATES", 0 },
  { "Y_COORDINATES", 0 }, { "Z_COORDINATES", 0 } };
const std::set<std::string> OfGrids = { "CELLS", "CELL_TYPES", "POINTS", "X_COORDINATES",
  "Y_COORDINATES", "Z_COORDINATES" };

// Each cell is the number of its points and these. The reader believes what it is told of them.
void CheckCells(const std::string& path, std::streamoff at, bool isBinary)
{
  std::ifstream in(path, std::ios::binary);
  in.seekg(at);
  std::string word, count, entries;
  in >> word >> count >> entries;
  long long cells = 0, numbers = 0;
  if (!IsWhole(count, 0, LLONG_MAX, cells) || !IsWhole(entries, 0, LLONG_MAX, numbers))
  {
    throw Damaged(path, "it tells of no numbers of CELLS");
  }
  std::getline(in, word); // what is left of the line
  const std::streamoff begin = in.tellg();
  if (in >> word && LowerCase(word) == "offsets")
  {
    return; // as files are since version 5, which are checked when they are read
  }
  in.clear();
  in.seekg(begin);
  const auto next = [&in, isBinary]
  {
    long long number = -1;
    if (!isBinary)
    {
      in >> number;
      return in ? number : -1;
    }
    std::array<unsigned char, 4> bytes{};
    in.read(reinterpret_cast<char*>(bytes.data()), 4);
    const std::uint32_t bits = std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 |
      std::uint32_t(bytes[2]) << 8 | std::uint32_t(bytes[3]);
    return in ? static_cast<long long>(static_cast<std::int32_t>(bits)) : -1;
  };
  long long left = numbers;
  for (long long cell = 0; cell < cells; ++cell)
  {
    const long long points = left > 0 ? next() : -1;
    left -= points + 1;
    if (points < 0 || left < 0)
    {
      throw Damaged(path, "its CELLS have other numbers of points than it tells of");
    }
    for (long long point = 0; point < points && in; ++point)
    {
      next();
    }
  }
  if (left != 0)
  {
    throw Damaged(path, "its CELLS have other numbers of points than it tells of");
  }
}

// \param titleEnd what comes before are no keywords
void CheckCounts(const std::string& path, std::streamoff titleEnd, bool isBinary, double there)
{
  constexpr std::size_t Chunk = 1 << 20, Longest = 600; // bytes
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::streamoff begin = 0; // of the text, in the file
  while (file)
  {
    // What was at the end may go on.
    const std::size_t kept = std::min(text.size(), 2 * Longest);
    begin += static_cast<std::streamoff>(text.size() - kept);
    text.erase(0, text.size() - kept);
    text.resize(kept + Chunk);
    file.read(&text[kept], Chunk);
    text.resize(kept + static_cast<std::size_t>(file.gcount()));
    for (const auto& [keyword, wordsBefore] : Counted)
    {
      // What begins before that was looked at with the text before.
      for (std::size_t at = text.find(keyword, begin > 0 ? Longest : 0); at != std::string::npos;
           at = text.find(keyword, at + 1))
      {
        std::istringstream in(text.substr(at, Longest));
        std::string word, other, count;
        in >> word;
        for (int i = 0; i < wordsBefore; ++i)
        {
          in >> other;
        }
        in >> count;
        const std::size_t before = std::min(at, Longest);
        if (word == "LOOKUP_TABLE" && IsOfScalars(text.substr(at - before, before)))
        {
          continue;
        }
        if (word == "SCALARS" && at > 0 && text[at - 1] == '_')
        {
          continue; // COLOR_SCALARS
        }
        long long number = 0;
        const bool isCounted = IsWhole(count, LLONG_MIN, LLONG_MAX, number);
        // Each takes some characters.
        const bool isNegative = number < 0 && OfGrids.count(word) == 1;
        if (word == keyword && isCounted &&
          (isNegative || static_cast<double>(number) > there / 4.0))
        {
          throw Damaged(path, "it tells of " + count + " entries of " + keyword);
        }
        // Within a line it may be a name.
        const bool isLine = at > 0 && text[at - 1] == '\n';
        if (word == "CELLS" && isLine && begin + static_cast<std::streamoff>(at) >= titleEnd)
        {
          CheckCells(path, begin + static_cast<std::streamoff>(at), isBinary);
        }
        if (word == "FIELD" && (isLine || isCounted) &&
          begin + static_cast<std::streamoff>(at) >= titleEnd)
        {
          CheckField(path, begin + static_cast<std::streamoff>(at), isBinary, there);
        }
      }
    }
  }
}

}

std::string CheckLegacyFile(const std::string& path)
{
  std::istringstream in(BytesOf(path, MostHeader));
  std::string line, kind;
  std::getline(in, line);
  if (line.compare(0, 14, "# vtk DataFile") != 0 || line.size() > MostLine)
  {
    throw Damaged(path, "it does not begin as VTK's files do");
  }
  std::getline(in, line); // its title
  if (line.size() > MostLine)
  {
    throw Damaged(path, "its title is too long");
  }
  const std::streamoff titleEnd = in.tellg();
  std::string encoding, keyword;
  in >> encoding >> keyword >> kind;
  kind = LowerCase(kind);
  if (LowerCase(keyword) == "field")
  {
    kind = "field";
  }
  const auto other = Refused.find(kind);
  if (other != Refused.end())
  {
    throw UserError(Quoted(path) + " holds a " + other->second +
      ", which has no cells with a volume; choose a file with an image or a grid.");
  }
  if (LowerCase(keyword) != "dataset" || Kinds.count(kind) == 0)
  {
    throw Damaged(path, "its header tells of no dataset");
  }
  const auto there = static_cast<double>(SizeOf(path));
  CheckCounts(path, titleEnd, LowerCase(encoding) == "binary", there);
  for (std::string word; in >> word;)
  {
    std::string size;
    if (LowerCase(word) == "point_data" || LowerCase(word) == "cell_data")
    {
      break;
    }
    if (LowerCase(word) == "dimensions")
    {
      double samples = 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        long long number = 0;
        if (!(in >> size) || !IsWhole(size, 1, INT_MAX, number))
        {
          throw Damaged(path, "its dimensions are no numbers");
        }
        samples *= static_cast<double>(number);
      }
      // There are samples of one bit.
      RequireSamples(path, samples, 0.125, there);
    }
  }
  return kind;
}
