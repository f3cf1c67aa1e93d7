// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/VtiVolume.h"

#include "VolumeFiles/RandomAccessFile.h"
#include "VolumeFiles/RawVolume.h"
#include "VolumeFiles/VolumeHeader.h"
#include "VolumeFiles/VtiHeader.h"

#include <array>
#include <limits>
#include <utility>

namespace TemporalCoherence
{
namespace
{

const char* const OtherReader = "use vtkXMLImageDataReader as a reader";

bool TypeOf(const std::string& name, ScalarType& type)
{
  static constexpr std::array<std::pair<const char*, ScalarType>, 10> types = { {
    { "Int8", ScalarType::Int8 },
    { "UInt8", ScalarType::UInt8 },
    { "Int16", ScalarType::Int16 },
    { "UInt16", ScalarType::UInt16 },
    { "Int32", ScalarType::Int32 },
    { "UInt32", ScalarType::UInt32 },
    { "Int64", ScalarType::Int64 },
    { "UInt64", ScalarType::UInt64 },
    { "Float32", ScalarType::Float32 },
    { "Float64", ScalarType::Float64 },
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

/// What keeps the file's samples from being used as they lie there; empty if nothing does.
std::string Obstacle(const VtiHeader& header)
{
  if (header.File.Get("type") != "ImageData")
  {
    return "it is no file of VTK's image data";
  }
  if (!header.File.Get("compressor").empty())
  {
    return "its data are compressed";
  }
  if (header.NumberOfPieces != 1)
  {
    return "it has " + std::to_string(header.NumberOfPieces) + " pieces instead of one";
  }
  if (!header.HasAppended || header.Appended.Get("encoding") != "raw")
  {
    return "its data are not appended as raw bytes";
  }
  const std::string order = header.File.Get("byte_order");
  if (order != "LittleEndian" && order != "BigEndian")
  {
    return "its byte order '" + order + "' is unknown";
  }
  const std::string sizes = header.File.Get("header_type", "UInt32");
  if (sizes != "UInt32" && sizes != "UInt64")
  {
    return "its header type '" + sizes + "' is unknown";
  }
  return {};
}

/// Read the places of samples.
/// \return what is wrong; empty if nothing is
std::string ReadPlaces(const VtiHeader& header, RawLayout& layout)
{
  std::int64_t extent[6], piece[6];
  if (!ParseIntegers(header.Image.Get("WholeExtent"), 6, extent) ||
    !ParseIntegers(header.Piece.Get("Extent"), 6, piece) ||
    !ParseNumbers(header.Image.Get("Origin", "0 0 0"), 3, &layout.Origin.x) ||
    !ParseNumbers(header.Image.Get("Spacing", "1 1 1"), 3, &layout.Spacing.x))
  {
    return "WholeExtent, Extent, Origin or Spacing has no correct numbers";
  }
  double direction[9];
  if (!ParseNumbers(header.Image.Get("Direction", "1 0 0 0 1 0 0 0 1"), 9, direction) ||
    !IsIdentity(direction))
  {
    return "its Direction is no identity matrix and would not be kept";
  }
  constexpr int most = std::numeric_limits<int>::max();
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t low = extent[2 * axis], high = extent[2 * axis + 1];
    if (low != piece[2 * axis] || high != piece[2 * axis + 1])
    {
      return "its piece does not fill WholeExtent";
    }
    if (low < -most || high > most || low > high || high - low >= most)
    {
      return "its WholeExtent is empty or too large";
    }
    layout.Dimensions[axis] = static_cast<int>(high - low + 1);
    layout.Origin[axis] += layout.Spacing[axis] * static_cast<double>(low);
  }
  return {};
}

/// Choose an array and read its type.
/// \return what is wrong; empty if nothing is
std::string ReadArray(
  const VtiHeader& header, std::string name, RawLayout& layout, std::uint64_t& offset)
{
  name = name.empty() ? header.PointData.Get("Scalars") : name;
  const XmlAttributes* found = nullptr;
  for (const XmlAttributes& array : header.Arrays)
  {
    found = !found && (name.empty() || array.Get("Name") == name) ? &array : found;
  }
  if (!found)
  {
    return "it has no array '" + name + "' on points";
  }
  name = "its array '" + found->Get("Name") + "' ";
  if (found->Get("NumberOfComponents", "1") != "1")
  {
    return name + "has several components";
  }
  if (found->Get("format") != "appended")
  {
    return name + "is not appended as raw bytes";
  }
  if (!TypeOf(found->Get("type"), layout.Type))
  {
    return name + "has the unknown type '" + found->Get("type") + "'";
  }
  std::int64_t place = -1;
  if (!ParseIntegers(found->Get("offset"), 1, &place) || place < 0)
  {
    return name + "has no correct offset";
  }
  offset = static_cast<std::uint64_t>(place);
  return {};
}

/// Before the samples, the file tells their size.
/// \param offset of the array in the appended data, which begin at `layout.Offset`
bool SkipSize(const std::string& path, const VtiHeader& header, std::uint64_t offset,
  RawLayout& layout, std::string& error)
{
  std::uint64_t expected = 0;
  const std::unique_ptr<RandomAccessFile> file = RandomAccessFile::Open(path, error);
  if (!file || !CheckLayout(path, layout, error) ||
    !BytesOf(layout.Dimensions, layout.Type, expected))
  {
    return false;
  }
  const std::size_t count = header.File.Get("header_type") == "UInt64" ? 8 : 4;
  std::array<unsigned char, 8> bytes{};
  if (offset > file->Size())
  {
    error = HeaderError(path, "an array lies beyond its end", "copy the file again");
    return false;
  }
  if (!file->Read(layout.Offset + offset, bytes.data(), count, error))
  {
    return false;
  }
  std::uint64_t told = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    told = told << 8 | bytes[layout.IsBigEndian ? i : count - 1 - i];
  }
  if (told != expected)
  {
    error = HeaderError(path,
      "the array has " + std::to_string(told) + " bytes instead of " + std::to_string(expected),
      "write the file again");
    return false;
  }
  layout.Offset += offset + count;
  return true;
}

}

std::unique_ptr<VolumeFile> OpenVti(
  const std::string& path, const std::string& array, std::string& error)
{
  HeaderText text;
  if (!ReadHeader(path, text, error))
  {
    return nullptr;
  }
  VtiHeader header;
  std::size_t data = 0;
  std::string what;
  if (!ParseVti(text.Text, header, data, what))
  {
    error = HeaderError(path, what, "write the file again");
    return nullptr;
  }
  RawLayout layout;
  std::uint64_t offset = 0;
  what = Obstacle(header);
  what = what.empty() ? ReadPlaces(header, layout) : what;
  what = what.empty() ? ReadArray(header, array, layout, offset) : what;
  what = what.empty() && data == 0 ? "its appended data do not begin in the first MiB" : what;
  if (!what.empty())
  {
    error = HeaderError(path, what, OtherReader);
    return nullptr;
  }
  layout.Offset = data;
  layout.IsBigEndian = header.File.Get("byte_order") == "BigEndian";
  return SkipSize(path, header, offset, layout, error) ? OpenRaw(path, layout, error) : nullptr;
}

}
