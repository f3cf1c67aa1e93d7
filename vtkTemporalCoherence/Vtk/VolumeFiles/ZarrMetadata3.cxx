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

constexpr NamedType Types[] = { { "bool", ScalarType::UInt8 }, { "int8", ScalarType::Int8 },
  { "uint8", ScalarType::UInt8 }, { "int16", ScalarType::Int16 }, { "uint16", ScalarType::UInt16 },
  { "int32", ScalarType::Int32 }, { "uint32", ScalarType::UInt32 }, { "int64", ScalarType::Int64 },
  { "uint64", ScalarType::UInt64 }, { "float32", ScalarType::Float32 },
  { "float64", ScalarType::Float64 } };

bool ParseType(const std::string& text, ScalarType& type)
{
  for (const NamedType& named : Types)
  {
    if (text == named.Name)
    {
      type = named.Type;
      return true;
    }
  }
  return false;
}

const Json& ConfigurationOf(const Json& codec)
{
  return MemberOf(codec, "configuration");
}

/// Read the name of a codec, which may stand alone or in an object.
std::string NameOf(const Json& codec)
{
  return codec.is_string() ? codec.get<std::string>() : TextOf(codec, "name");
}

/// Codecs in their order: at most one of each step.
struct CodecSteps
{
  bool HasBytes = false;
  bool IsBigEndian = false;
  ChunkCodec Codec;
};

/// \return false if the codec is unknown, or stands at a wrong place
bool TakeCodec(const Json& codec, CodecSteps& steps)
{
  const std::string name = NameOf(codec);
  ChunkCodec& chunk = steps.Codec;
  if (name == "bytes")
  {
    const std::string endian = TextOf(ConfigurationOf(codec), "endian");
    const bool isFirst = !steps.HasBytes;
    steps.HasBytes = true;
    steps.IsBigEndian = endian == "big";
    return isFirst && (endian.empty() || endian == "little" || endian == "big");
  }
  if (!steps.HasBytes || chunk.HasChecksum)
  {
    return false;
  }
  if (name == "crc32c")
  {
    chunk.HasChecksum = true;
    return true;
  }
  const bool isFirst = chunk.Compression == ChunkCompression::None;
  chunk.Compression = name == "blosc"            ? ChunkCompression::Blosc
    : name == "zstd"                             ? ChunkCompression::Zstd
    : name == "gzip" || name == "numcodecs.zlib" ? ChunkCompression::Zlib
                                                 : ChunkCompression::None;
  return isFirst && chunk.Compression != ChunkCompression::None;
}

bool ParseCodecs(const Json& codecs, CodecSteps& steps)
{
  if (!codecs.is_array())
  {
    return false;
  }
  for (const Json& codec : codecs)
  {
    if (!TakeCodec(codec, steps))
    {
      return false;
    }
  }
  return steps.HasBytes;
}

bool ParseIndexCodecs(const Json& codecs, ZarrShard& shard)
{
  CodecSteps steps;
  const bool isGood =
    ParseCodecs(codecs, steps) && steps.Codec.Compression == ChunkCompression::None;
  shard.HasIndexChecksum = steps.Codec.HasChecksum;
  shard.IsIndexBigEndian = steps.IsBigEndian;
  return isGood;
}

/// Split the file's shape, read as the array's chunk, into its chunks.
bool DivideShard(const Json& shape, ZarrArray& array)
{
  std::vector<int> inner;
  if (!ParseZarrSizes(shape, inner) || inner.size() != array.Chunk.size())
  {
    return false;
  }
  // The index has 16 bytes for each chunk. A longer one than 32 GiB is a mistake.
  constexpr std::uint64_t MostChunks = std::numeric_limits<std::int32_t>::max();
  std::uint64_t count = 1;
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    const int chunks = array.Chunk[i] / inner[i];
    count *= static_cast<std::uint64_t>(chunks);
    if (array.Chunk[i] % inner[i] != 0 || count > MostChunks)
    {
      return false;
    }
    array.Shard.Chunks.push_back(chunks);
  }
  array.Shard.Count = static_cast<std::size_t>(count);
  array.Chunk = inner;
  return true;
}

bool ParseSharding(const Json& codec, ZarrArray& array, const Json*& codecs, std::string& defect)
{
  const Json& configuration = ConfigurationOf(codec);
  if (!DivideShard(MemberOf(configuration, "chunk_shape"), array))
  {
    defect = "has shards that are not divided into whole chunks; copy the volume again";
    return false;
  }
  const Json& place = MemberOf(configuration, "index_location");
  array.Shard.IsIndexAtStart = place == "start";
  codecs = &MemberOf(configuration, "codecs");
  defect = "has an index of shards with codecs other than bytes and crc32c; write the volume with "
           "these";
  return (place.is_null() || place == "start" || place == "end") &&
    ParseIndexCodecs(MemberOf(configuration, "index_codecs"), array.Shard);
}

bool ParseKeys(const Json& encoding, ZarrArray& array, std::string& defect)
{
  const std::string name = NameOf(encoding);
  const Json& separator = MemberOf(ConfigurationOf(encoding), "separator");
  const bool isDefault = name == "default";
  array.Separator = separator.is_null() ? (isDefault ? '/' : '.') : separator == "/" ? '/' : '.';
  array.KeyPrefix = isDefault ? std::string("c") + array.Separator : std::string();
  defect = "has a chunk_key_encoding that is not known; write the volume with \"default\"";
  return (isDefault || name == "v2") &&
    (separator.is_null() || separator == "/" || separator == ".");
}

bool ParseStorage(const Json& metadata, ZarrArray& array, std::string& defect)
{
  const Json* codecs = &MemberOf(metadata, "codecs");
  const bool isSharded =
    codecs->is_array() && codecs->size() == 1 && NameOf(codecs->front()) == "sharding_indexed";
  if (isSharded && !ParseSharding(codecs->front(), array, codecs, defect))
  {
    return false;
  }
  CodecSteps steps;
  if (!ParseCodecs(*codecs, steps))
  {
    defect = "names codecs that are not known in this order; write the volume with bytes and then "
             "blosc, zstd or gzip";
    return false;
  }
  array.Codec = steps.Codec;
  array.Codec.SwapBytes = SizeOf(array.Type) > 1 && steps.IsBigEndian == IsLittleEndianMachine();
  return ParseKeys(MemberOf(metadata, "chunk_key_encoding"), array, defect);
}

}

bool ParseZarrArray3(const Json& metadata, ZarrArray& array, std::string& defect)
{
  array = ZarrArray();
  if (MemberOf(metadata, "zarr_format") != 3 || TextOf(metadata, "node_type") != "array")
  {
    defect = "does not describe an array of zarr_format 3; copy the volume again";
    return false;
  }
  const Json& grid = MemberOf(metadata, "chunk_grid");
  if (TextOf(grid, "name") != "regular")
  {
    defect = "has a chunk_grid that is not regular; write the volume with chunks of one size";
    return false;
  }
  if (!ParseZarrSizes(MemberOf(metadata, "shape"), array.Shape) ||
    !ParseZarrSizes(MemberOf(ConfigurationOf(grid), "chunk_shape"), array.Chunk))
  {
    defect = "has a shape or a chunk_shape that is not a list of integers from 1 to 2147483647; "
             "copy the volume again";
    return false;
  }
  if (!ParseType(TextOf(metadata, "data_type"), array.Type))
  {
    defect = "has a data_type that is no real number of 1, 2, 4 or 8 bytes; convert the samples";
    return false;
  }
  if (!ParseZarrFillValue(MemberOf(metadata, "fill_value"), array.Type, array.FillValue))
  {
    defect = "has a fill_value that the data_type cannot hold; set another fill_value";
    return false;
  }
  return ParseStorage(metadata, array, defect) && CheckZarrSizes(array, defect);
}

}
