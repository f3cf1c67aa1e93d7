// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/MetaImageVolume.h"

#include "VolumeFiles/RawVolume.h"
#include "VolumeFiles/VolumeHeader.h"

#include <array>
#include <initializer_list>
#include <map>
#include <utility>

namespace TemporalCoherence
{
namespace
{

const char* const OtherReader = "use vtkMetaImageReader as a reader";

/// The lines of a header. ElementDataFile ends it.
struct MetaHeader
{
  std::map<std::string, std::string> Values;
  std::size_t End = 0; ///< the first byte after the header

  /// The value of the first of several keys that the header has.
  std::string Get(std::initializer_list<const char*> keys, const std::string& fallback) const
  {
    for (const char* key : keys)
    {
      const auto found = this->Values.find(key);
      if (found != this->Values.end())
      {
        return found->second;
      }
    }
    return fallback;
  }
};

MetaHeader ParseMetaHeader(const std::string& text)
{
  MetaHeader header;
  std::string line;
  while (!header.Values.count("ElementDataFile") && NextLine(text, header.End, line))
  {
    const std::size_t separator = line.find_first_of("=:");
    if (separator != std::string::npos)
    {
      header.Values[Trimmed(line.substr(0, separator))] = Trimmed(line.substr(separator + 1));
    }
  }
  return header;
}

bool IsTrue(const std::string& value)
{
  return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

/// Types that have the same size everywhere.
bool TypeOf(const std::string& name, ScalarType& type)
{
  static constexpr std::array<std::pair<const char*, ScalarType>, 10> types = { {
    { "MET_CHAR", ScalarType::Int8 },
    { "MET_UCHAR", ScalarType::UInt8 },
    { "MET_SHORT", ScalarType::Int16 },
    { "MET_USHORT", ScalarType::UInt16 },
    { "MET_INT", ScalarType::Int32 },
    { "MET_UINT", ScalarType::UInt32 },
    { "MET_LONG_LONG", ScalarType::Int64 },
    { "MET_ULONG_LONG", ScalarType::UInt64 },
    { "MET_FLOAT", ScalarType::Float32 },
    { "MET_DOUBLE", ScalarType::Float64 },
  } };
  for (const auto& entry : types)
  {
    if (name == entry.first)
    {
      type = entry.second;
      return true;
    }
  }
  return false;
}

/// What keeps the samples from being used as they lie in the file; empty if nothing does.
std::string Obstacle(const MetaHeader& header)
{
  if (!header.Values.count("ElementDataFile"))
  {
    return "it has no line ElementDataFile in the first MiB";
  }
  if (header.Get({ "NDims" }, "3") != "3")
  {
    return "it has not three dimensions";
  }
  if (header.Get({ "ElementNumberOfChannels" }, "1") != "1")
  {
    return "it has several channels";
  }
  if (IsTrue(header.Get({ "CompressedData" }, "False")) ||
    !IsTrue(header.Get({ "BinaryData" }, "True")))
  {
    return "its data are compressed or no raw bytes";
  }
  double slope = 1.0, offset = 0.0;
  if (!ParseNumbers(header.Get({ "ElementToIntensityFunctionSlope" }, "1"), 1, &slope) ||
    !ParseNumbers(header.Get({ "ElementToIntensityFunctionOffset" }, "0"), 1, &offset) ||
    slope != 1.0 || offset != 0.0)
  {
    return "its samples must be scaled (ElementToIntensityFunction)";
  }
  double matrix[9];
  if (!ParseNumbers(
        header.Get({ "TransformMatrix", "Rotation", "Orientation" }, "1 0 0 0 1 0 0 0 1"), 9,
        matrix) ||
    !IsIdentity(matrix))
  {
    return "its TransformMatrix is no identity matrix and would not be kept";
  }
  return {};
}

/// \return what is wrong; empty if nothing is
std::string ReadLayout(const MetaHeader& header, RawLayout& layout)
{
  if (!ParseDimensions(header.Get({ "DimSize" }, ""), layout.Dimensions))
  {
    return "its DimSize has not three positive numbers";
  }
  const std::string type = header.Get({ "ElementType" }, "");
  if (!TypeOf(type, layout.Type))
  {
    return "its ElementType '" + type + "' is unknown or differs among systems";
  }
  if (!ParseNumbers(
        header.Get({ "ElementSpacing", "ElementSize" }, "1 1 1"), 3, &layout.Spacing.x) ||
    !ParseNumbers(header.Get({ "Offset", "Position", "Origin" }, "0 0 0"), 3, &layout.Origin.x))
  {
    return "its ElementSpacing or Offset has not three numbers";
  }
  layout.IsBigEndian =
    IsTrue(header.Get({ "BinaryDataByteOrderMSB", "ElementByteOrderMSB" }, "False"));
  return {};
}

/// Find the file of samples, and the first one in it.
bool FindSamples(const HeaderText& text, const MetaHeader& header, RawLayout& layout,
  std::string& path, std::string& error)
{
  const std::string name = header.Get({ "ElementDataFile" }, "");
  const std::string firstWord = name.substr(0, name.find_first_of(" \t"));
  const bool isLocal = name == "LOCAL" || name == "Local" || name == "local";
  if (firstWord == "LIST" || name.find('%') != std::string::npos)
  {
    error = HeaderError(text.Path, "its samples lie in several files", OtherReader);
    return false;
  }
  path = text.Path;
  if (!isLocal && !FindDataFile(text, name, path, error))
  {
    return false;
  }
  std::int64_t size = 0;
  if (!ParseIntegers(header.Get({ "HeaderSize" }, "0"), 1, &size) || size < -1)
  {
    error = HeaderError(text.Path, "its HeaderSize is no number from -1", "correct it");
    return false;
  }
  if (size < 0)
  {
    return FindOffsetFromEnd(path, layout, error);
  }
  layout.Offset = isLocal && size == 0 ? header.End : static_cast<std::uint64_t>(size);
  return true;
}

}

std::unique_ptr<VolumeFile> OpenMetaImage(const std::string& path, std::string& error)
{
  HeaderText text;
  if (!ReadHeader(path, text, error))
  {
    return nullptr;
  }
  const MetaHeader header = ParseMetaHeader(text.Text);
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
