// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/NrrdVolume.h"

#include "VolumeFiles/RawVolume.h"
#include "VolumeFiles/VolumeHeader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

const char* const OtherReader = "use vtkNrrdReader as a reader";

/// The lines up to the first empty one.
struct NrrdHeader
{
  bool HasMagic = false;
  std::map<std::string, std::string> Values; ///< fields in lower case, without spaces
  std::size_t End = 0;                       ///< the first byte after the header

  std::string Get(const char* field, const std::string& fallback = {}) const
  {
    const auto found = this->Values.find(field);
    return found == this->Values.end() ? fallback : found->second;
  }
};

NrrdHeader ParseNrrdHeader(const std::string& text)
{
  NrrdHeader header;
  std::string line;
  header.HasMagic =
    NextLine(text, header.End, line) && line.size() == 8 && line.compare(0, 7, "NRRD000") == 0;
  while (header.HasMagic && NextLine(text, header.End, line) && !line.empty())
  {
    // Lines with := are keys of users.
    const std::size_t separator = line.find(':');
    if (line[0] == '#' || separator == std::string::npos || line.substr(separator, 2) == ":=")
    {
      continue;
    }
    std::string field = LowerCase(line.substr(0, separator));
    field.erase(std::remove(field.begin(), field.end(), ' '), field.end());
    header.Values[field] = Trimmed(line.substr(separator + 1));
  }
  return header;
}

/// The format has several names for each type.
bool TypeOf(const std::string& name, ScalarType& type)
{
  static const std::map<std::string, ScalarType> types = { { "signed char", ScalarType::Int8 },
    { "int8", ScalarType::Int8 }, { "int8_t", ScalarType::Int8 }, { "uchar", ScalarType::UInt8 },
    { "unsigned char", ScalarType::UInt8 }, { "uint8", ScalarType::UInt8 },
    { "uint8_t", ScalarType::UInt8 }, { "short", ScalarType::Int16 },
    { "short int", ScalarType::Int16 }, { "signed short", ScalarType::Int16 },
    { "signed short int", ScalarType::Int16 }, { "int16", ScalarType::Int16 },
    { "int16_t", ScalarType::Int16 }, { "ushort", ScalarType::UInt16 },
    { "unsigned short", ScalarType::UInt16 }, { "unsigned short int", ScalarType::UInt16 },
    { "uint16", ScalarType::UInt16 }, { "uint16_t", ScalarType::UInt16 },
    { "int", ScalarType::Int32 }, { "signed int", ScalarType::Int32 },
    { "int32", ScalarType::Int32 }, { "int32_t", ScalarType::Int32 },
    { "uint", ScalarType::UInt32 }, { "unsigned int", ScalarType::UInt32 },
    { "uint32", ScalarType::UInt32 }, { "uint32_t", ScalarType::UInt32 },
    { "longlong", ScalarType::Int64 }, { "long long", ScalarType::Int64 },
    { "long long int", ScalarType::Int64 }, { "signed long long", ScalarType::Int64 },
    { "signed long long int", ScalarType::Int64 }, { "int64", ScalarType::Int64 },
    { "int64_t", ScalarType::Int64 }, { "ulonglong", ScalarType::UInt64 },
    { "unsigned long long", ScalarType::UInt64 }, { "unsigned long long int", ScalarType::UInt64 },
    { "uint64", ScalarType::UInt64 }, { "uint64_t", ScalarType::UInt64 },
    { "float", ScalarType::Float32 }, { "double", ScalarType::Float64 } };
  const auto found = types.find(name);
  if (found == types.end())
  {
    return false;
  }
  type = found->second;
  return true;
}

/// What keeps the samples from being used as they lie in the file; empty if nothing does.
std::string Obstacle(const NrrdHeader& header)
{
  if (!header.HasMagic)
  {
    return "it does not begin with NRRD000 and a digit";
  }
  if (header.Get("dimension") != "3")
  {
    return "it has not three dimensions";
  }
  if (LowerCase(header.Get("encoding")) != "raw")
  {
    return "its encoding is not raw";
  }
  if (header.Get("lineskip", "0") != "0")
  {
    return "lines before its samples cannot be skipped";
  }
  std::istringstream kinds(LowerCase(header.Get("kinds")));
  for (std::string kind; kinds >> kind;)
  {
    if (kind != "domain" && kind != "space" && kind != "none" && kind != "???")
    {
      return "an axis is no axis of space, but of the kind '" + kind + "'";
    }
  }
  return {};
}

/// Numbers in parentheses, with commas between them.
/// \param count of all numbers in the text
bool ParseVectors(std::string text, std::size_t count, double* numbers)
{
  std::replace_if(
    text.begin(), text.end(),
    [](char letter) { return letter == '(' || letter == ')' || letter == ','; }, ' ');
  return ParseNumbers(text, count, numbers);
}

/// Spacings where `nan` tells that one is unknown.
bool ParseSpacings(const std::string& text, glm::dvec3& spacing)
{
  std::istringstream words(LowerCase(text));
  std::string known;
  for (std::string word; words >> word;)
  {
    known += (word == "nan" ? "1" : word) + ' ';
  }
  return ParseNumbers(known, 3, &spacing.x);
}

/// \return what is wrong; empty if nothing is
std::string ReadPlaces(const NrrdHeader& header, RawLayout& layout)
{
  if (!ParseSpacings(header.Get("spacings", "1 1 1"), layout.Spacing) ||
    !ParseVectors(header.Get("spaceorigin", "(0,0,0)"), 3, &layout.Origin.x))
  {
    return "its spacings or space origin has not three numbers";
  }
  double directions[9];
  if (header.Values.count("spacedirections") == 0)
  {
    return {};
  }
  if (!ParseVectors(header.Get("spacedirections"), 9, directions))
  {
    return "its space directions have not nine numbers";
  }
  constexpr double rounding = 1e-6;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* row = directions + 3 * axis;
    const double beside = std::abs(row[(axis + 1) % 3]) + std::abs(row[(axis + 2) % 3]);
    if (!(row[axis] > 0.0) || !(beside <= rounding * row[axis]))
    {
      return "its space directions are not those of x, y and z and would not be kept";
    }
    layout.Spacing[axis] = row[axis];
  }
  return {};
}

/// \return what is wrong; empty if nothing is
std::string ReadLayout(const NrrdHeader& header, RawLayout& layout)
{
  if (!ParseDimensions(header.Get("sizes"), layout.Dimensions))
  {
    return "its sizes are not three positive numbers";
  }
  if (!TypeOf(LowerCase(header.Get("type")), layout.Type))
  {
    return "its type '" + header.Get("type") + "' is unknown or differs among systems";
  }
  const std::string endian = LowerCase(header.Get("endian"));
  if (SizeOf(layout.Type) > 1 && endian != "little" && endian != "big")
  {
    return "its endian '" + endian + "' is neither little nor big";
  }
  layout.IsBigEndian = endian == "big";
  return ReadPlaces(header, layout);
}

/// Find the file of samples, and the first one in it.
bool FindSamples(const HeaderText& text, const NrrdHeader& header, RawLayout& layout,
  std::string& path, std::string& error)
{
  const std::string name = header.Get("datafile");
  const bool isLocal = header.Values.count("datafile") == 0;
  if (name.compare(0, 4, "LIST") == 0 || name.find('%') != std::string::npos)
  {
    error = HeaderError(text.Path, "its samples lie in several files", OtherReader);
    return false;
  }
  path = text.Path;
  if (!isLocal && !FindDataFile(text, name, path, error))
  {
    return false;
  }
  std::int64_t skip = 0;
  if (!ParseIntegers(header.Get("byteskip", "0"), 1, &skip) || skip < -1)
  {
    error = HeaderError(text.Path, "its byte skip is no number from -1", "correct it");
    return false;
  }
  if (skip < 0)
  {
    return FindOffsetFromEnd(path, layout, error);
  }
  layout.Offset = static_cast<std::uint64_t>(skip) + (isLocal ? header.End : 0);
  return true;
}

}

std::unique_ptr<VolumeFile> OpenNrrd(const std::string& path, std::string& error)
{
  HeaderText text;
  if (!ReadHeader(path, text, error))
  {
    return nullptr;
  }
  const NrrdHeader header = ParseNrrdHeader(text.Text);
  RawLayout layout;
  std::string what = Obstacle(header);
  what = what.empty() ? ReadLayout(header, layout) : what;
  if (!what.empty())
  {
    error = HeaderError(path, what, OtherReader);
    return nullptr;
  }
  std::string data;
  return FindSamples(text, header, layout, data, error) ? OpenRaw(data, layout, error) : nullptr;
}

}
