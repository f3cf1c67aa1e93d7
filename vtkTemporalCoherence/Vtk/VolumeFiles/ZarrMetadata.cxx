// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ZarrMetadata.h"

#include <limits>

namespace TemporalCoherence
{
namespace
{

struct NamedType
{
  const char* Name;
  ScalarType Type;
};

constexpr NamedType Types[] = { { "i1", ScalarType::Int8 }, { "u1", ScalarType::UInt8 },
  { "b1", ScalarType::UInt8 }, { "i2", ScalarType::Int16 }, { "u2", ScalarType::UInt16 },
  { "i4", ScalarType::Int32 }, { "u4", ScalarType::UInt32 }, { "i8", ScalarType::Int64 },
  { "u8", ScalarType::UInt64 }, { "f4", ScalarType::Float32 }, { "f8", ScalarType::Float64 } };

/// Read a type of NumPy: the byte order, a letter, and the number of bytes.
bool ParseType(const std::string& text, ZarrArray& array)
{
  if (text.size() != 3)
  {
    return false;
  }
  for (const NamedType& named : Types)
  {
    if (text.substr(1) == named.Name)
    {
      const bool isOneByte = SizeOf(named.Type) == 1;
      array.Type = named.Type;
      array.Codec.SwapBytes = !isOneByte && (text[0] == '<') != IsLittleEndianMachine();
      return text[0] == '<' || text[0] == '>' || (isOneByte && text[0] == '|');
    }
  }
  return false;
}

bool ParseCompressor(const Json& compressor, ChunkCompression& compression, std::string& defect)
{
  if (compressor.is_null())
  {
    compression = ChunkCompression::None;
    return true;
  }
  const std::string name = TextOf(compressor, "id");
  compression = name == "blosc"        ? ChunkCompression::Blosc
    : name == "zstd"                   ? ChunkCompression::Zstd
    : name == "gzip" || name == "zlib" ? ChunkCompression::Zlib
                                       : ChunkCompression::None;
  defect = "names a compressor that is not known; write the volume with blosc, zstd, gzip or zlib";
  return compression != ChunkCompression::None;
}

bool ParseStorage(const Json& metadata, ZarrArray& array, std::string& defect)
{
  const Json& filters = MemberOf(metadata, "filters");
  if (!filters.is_null() && !(filters.is_array() && filters.empty()))
  {
    defect = "names filters, which are not supported; write the volume without filters";
    return false;
  }
  if (TextOf(metadata, "order") != "C")
  {
    defect = "has samples in an order other than C; write the volume in order C";
    return false;
  }
  const Json& separator = MemberOf(metadata, "dimension_separator");
  if (!separator.is_null() && separator != "." && separator != "/")
  {
    defect = "names a dimension_separator other than \".\" and \"/\"; copy the volume again";
    return false;
  }
  array.Separator = separator == "/" ? '/' : '.';
  return ParseCompressor(MemberOf(metadata, "compressor"), array.Codec.Compression, defect);
}

}

bool ParseZarrSizes(const Json& list, std::vector<int>& sizes)
{
  sizes.clear();
  for (const Json& size : list)
  {
    // Not a signed comparison: values from 2^63 on would be negative.
    const bool isPositive =
      size.is_number_unsigned() || (size.is_number_integer() && size.get<std::int64_t>() > 0);
    const std::uint64_t value = isPositive ? size.get<std::uint64_t>() : 0;
    if (value == 0 || value > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    {
      return false;
    }
    sizes.push_back(static_cast<int>(value));
  }
  return list.is_array();
}

bool CheckZarrSizes(ZarrArray& array, std::string& defect)
{
  constexpr std::size_t FewestAxes = 2, MostAxes = 5;
  if (array.Shape.size() < FewestAxes || array.Shape.size() > MostAxes)
  {
    defect = "has " + std::to_string(array.Shape.size()) + " axes; give an array with 2 to 5";
    return false;
  }
  if (array.Chunk.size() != array.Shape.size())
  {
    defect = "has chunks with another number of axes than the array; copy the volume again";
    return false;
  }
  // Each factor and each product before the check has less than 32 bits.
  constexpr std::uint64_t MostBytes = std::numeric_limits<std::int32_t>::max();
  std::uint64_t bytes = SizeOf(array.Type);
  for (const int size : array.Chunk)
  {
    bytes *= static_cast<std::uint64_t>(size);
    if (bytes > MostBytes)
    {
      defect = "has chunks of 2 GiB or more; write the volume with smaller chunks";
      return false;
    }
  }
  array.ChunkBytes = static_cast<std::size_t>(bytes);
  return true;
}

bool ParseZarrArray2(const Json& metadata, ZarrArray& array, std::string& defect)
{
  array = ZarrArray();
  if (MemberOf(metadata, "zarr_format") != 2)
  {
    defect = "has a zarr_format other than 2; write the volume in format 2";
    return false;
  }
  if (!ParseZarrSizes(MemberOf(metadata, "shape"), array.Shape) ||
    !ParseZarrSizes(MemberOf(metadata, "chunks"), array.Chunk))
  {
    defect = "has a shape or chunks that are not lists of integers from 1 to 2147483647; copy the "
             "volume again";
    return false;
  }
  if (!ParseType(TextOf(metadata, "dtype"), array))
  {
    defect = "has a dtype that is no real number of 1, 2, 4 or 8 bytes; convert the samples";
    return false;
  }
  if (!ParseZarrFillValue(MemberOf(metadata, "fill_value"), array.Type, array.FillValue))
  {
    defect = "has a fill_value that the dtype cannot hold; set another fill_value";
    return false;
  }
  return CheckZarrSizes(array, defect) && ParseStorage(metadata, array, defect);
}

FileState ReadZarrArray(
  JsonFiles& files, const std::filesystem::path& folder, ZarrArray& array, std::string& error)
{
  Json metadata;
  std::filesystem::path path = folder / ".zarray";
  FileState state = files.Read(path, metadata, error);
  std::string defect;
  bool isGood = state == FileState::Opened && ParseZarrArray2(metadata, array, defect);
  if (state == FileState::Missing)
  {
    path = folder / "zarr.json";
    state = files.Read(path, metadata, error);
    if (state == FileState::Opened && TextOf(metadata, "node_type") == "group")
    {
      return FileState::Missing;
    }
    isGood = state == FileState::Opened && ParseZarrArray3(metadata, array, defect);
  }
  if (state == FileState::Opened && !isGood)
  {
    error = "File " + path.string() + ' ' + defect + '.';
    return FileState::Refused;
  }
  return state;
}

}
