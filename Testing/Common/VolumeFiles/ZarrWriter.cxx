// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ZarrWriter.h"

#include "VolumeFiles/ChunkCodec.h"
#include "VolumeFiles/SampleBytes.h"

#include <blosc.h>
#include <zlib.h>
#include <zstd.h>

#include <fstream>
#include <sstream>
#include <system_error>

namespace TemporalCoherence
{
namespace
{

namespace fs = std::filesystem;
using Bytes = std::vector<unsigned char>;

std::string NameOfType2(ScalarType type, bool isBigEndian)
{
  constexpr const char* Names[] = { "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8" };
  const std::string order = SizeOf(type) == 1 ? "|" : isBigEndian ? ">" : "<";
  return order + Names[static_cast<int>(type)];
}

std::string NameOfType3(ScalarType type)
{
  constexpr const char* Names[] = { "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64",
    "uint64", "float32", "float64" };
  return Names[static_cast<int>(type)];
}

bool IsBlosc(const std::string& compressor)
{
  return compressor.compare(0, 6, "blosc-") == 0;
}

/// A list of numbers along t, c, z, y and x.
template <typename Vector, typename Number>
std::string List(Number time, Number channel, const Vector& space)
{
  std::ostringstream text;
  text.precision(17);
  text << '[' << time << ", " << channel << ", " << space.z << ", " << space.y << ", " << space.x
       << ']';
  return text.str();
}

std::string Compressor2(const ZarrWriterSettings& settings)
{
  if (settings.Compressor.empty())
  {
    return "null";
  }
  const std::string effort = std::to_string(settings.Effort);
  return IsBlosc(settings.Compressor)
    ? R"({"id": "blosc", "cname": ")" + settings.Compressor.substr(6) + R"(", "clevel": )" +
      effort + R"(, "shuffle": 1, "blocksize": 0})"
    : R"({"id": ")" + settings.Compressor + R"(", "level": )" + effort + "}";
}

std::string Codecs3(const ZarrWriterSettings& settings)
{
  const std::string effort = std::to_string(settings.Effort);
  std::string text = R"([{"name": "bytes", "configuration": {"endian": ")";
  text += settings.IsBigEndian ? R"(big"}})" : R"(little"}})";
  if (IsBlosc(settings.Compressor))
  {
    text += R"(, {"name": "blosc", "configuration": {"cname": ")" + settings.Compressor.substr(6) +
      R"(", "clevel": )" + effort + R"(, "shuffle": "shuffle", "typesize": )" +
      std::to_string(SizeOf(settings.Type)) + R"(, "blocksize": 0}})";
  }
  else if (!settings.Compressor.empty())
  {
    text += R"(, {"name": ")" + settings.Compressor + R"(", "configuration": {"level": )" + effort +
      (settings.Compressor == "zstd" ? R"(, "checksum": false}})" : "}}");
  }
  return text + (settings.HasChecksum ? R"(, {"name": "crc32c"}])" : "]");
}

Bytes CompressBlosc(const ZarrWriterSettings& settings, const Bytes& from)
{
  Bytes to(from.size() + BLOSC_MAX_OVERHEAD);
  const int size = blosc_compress_ctx(settings.Effort, BLOSC_SHUFFLE, SizeOf(settings.Type),
    from.size(), from.data(), to.data(), to.size(), settings.Compressor.substr(6).c_str(), 0, 1);
  to.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return to;
}

Bytes CompressZlib(const ZarrWriterSettings& settings, const Bytes& from)
{
  constexpr int LargestWindow = 15, GzipHeader = 16, Memory = 8;
  z_stream stream{};
  const int window = LargestWindow + (settings.Compressor == "gzip" ? GzipHeader : 0);
  if (deflateInit2(&stream, settings.Effort, Z_DEFLATED, window, Memory, Z_DEFAULT_STRATEGY) !=
    Z_OK)
  {
    return {};
  }
  Bytes to(deflateBound(&stream, static_cast<uLong>(from.size())));
  stream.next_in = const_cast<unsigned char*>(from.data());
  stream.avail_in = static_cast<uInt>(from.size());
  stream.next_out = to.data();
  stream.avail_out = static_cast<uInt>(to.size());
  const bool isWhole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  to.resize(isWhole ? stream.total_out : 0);
  deflateEnd(&stream);
  return to;
}

Bytes CompressZstd(const ZarrWriterSettings& settings, const Bytes& from)
{
  Bytes to(ZSTD_compressBound(from.size()));
  const std::size_t size =
    ZSTD_compress(to.data(), to.size(), from.data(), from.size(), settings.Effort);
  to.resize(ZSTD_isError(size) ? 0 : size);
  return to;
}

/// Append an integer, the lowest byte first.
void Append(std::uint64_t value, int count, Bytes& to)
{
  for (int i = 0; i < count; ++i)
  {
    to.push_back(static_cast<unsigned char>(value >> (8 * i)));
  }
}

bool WriteBytes(const fs::path& path, const char* bytes, std::size_t size)
{
  std::error_code code;
  fs::create_directories(path.parent_path(), code);
  // Some file systems write a replaced file to the disk at once, which takes long.
  fs::remove(path, code);
  std::ofstream file(path, std::ios::binary);
  file.write(bytes, static_cast<std::streamsize>(size));
  file.close();
  return !file.fail();
}

}

bool WriteZarrFile(const fs::path& path, const std::string& contents)
{
  return WriteBytes(path, contents.data(), contents.size());
}

bool ZarrWriter::Open(const fs::path& folder, const ZarrWriterSettings& settings,
  const std::vector<ZarrWriterLevel>& levels)
{
  this->Folder = folder;
  this->Settings = settings;
  this->Levels = levels;
  const bool isOld = settings.Format == 2;
  bool isGood = WriteZarrFile(folder / (isOld ? ".zattrs" : "zarr.json"), this->ImageMetadata()) &&
    (!isOld || WriteZarrFile(folder / ".zgroup", R"({"zarr_format": 2})"));
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    const fs::path path = folder / std::to_string(i) / (isOld ? ".zarray" : "zarr.json");
    isGood = isGood && WriteZarrFile(path, this->ArrayMetadata(levels[i]));
  }
  return isGood;
}

std::string ZarrWriter::ImageMetadata() const
{
  std::string dataSets;
  for (std::size_t i = 0; i < this->Levels.size(); ++i)
  {
    const ZarrWriterLevel& level = this->Levels[i];
    dataSets += (i > 0 ? ", " : "") + (R"({"path": ")" + std::to_string(i)) +
      R"(", "coordinateTransformations": [{"type": "scale", "scale": )" +
      List(1.0, 1.0, level.Scale) + R"(}, {"type": "translation", "translation": )" +
      List(0.0, 0.0, level.Translation) + "}]}";
  }
  const bool isOld = this->Settings.Format == 2;
  const std::string image = R"("multiscales": [{"version": "0.4", "name": "image", "axes": [
{"name": "t", "type": "time"}, {"name": "c", "type": "channel"},
{"name": "z", "type": "space", "unit": "micrometer"},
{"name": "y", "type": "space", "unit": "micrometer"},
{"name": "x", "type": "space", "unit": "micrometer"}],
"datasets": [)" +
    dataSets + "]}]";
  return isOld ? "{" + image + "}"
               : R"({"zarr_format": 3, "node_type": "group", "attributes": {"ome": {
"version": "0.5", )" +
      image + "}}}";
}

std::string ZarrWriter::ArrayMetadata(const ZarrWriterLevel& level) const
{
  const ZarrWriterSettings& settings = this->Settings;
  const std::string separator = std::string("\"") + settings.Separator + '"';
  const std::string shape = List(settings.TimePoints, settings.Channels, level.Dimensions);
  const std::string chunk = List(settings.TimePointsOfChunk, settings.ChannelsOfChunk, level.Chunk);
  if (settings.Format == 2)
  {
    return R"({"zarr_format": 2, "shape": )" + shape + R"(, "chunks": )" + chunk +
      R"(, "dtype": ")" + NameOfType2(settings.Type, settings.IsBigEndian) +
      R"(", "compressor": )" + Compressor2(settings) + R"(, "fill_value": )" + settings.FillValue +
      R"(, "order": "C", "filters": null, "dimension_separator": )" + separator + "}";
  }
  const bool isSharded = settings.Shard.x > 0;
  const std::string sharding =
    R"([{"name": "sharding_indexed", "configuration": {"chunk_shape": )" + chunk +
    R"(, "codecs": )" + Codecs3(settings) +
    R"(, "index_codecs": [{"name": "bytes", "configuration": {"endian": "little"}},
{"name": "crc32c"}], "index_location": ")" +
    (settings.IsIndexAtStart ? "start" : "end") + R"("}}])";
  const std::string outer =
    List(settings.TimePointsOfChunk, settings.ChannelsOfChunk, level.Chunk * settings.Shard);
  return R"({"zarr_format": 3, "node_type": "array", "shape": )" + shape + R"(, "data_type": ")" +
    NameOfType3(settings.Type) +
    R"(", "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": )" +
    (isSharded ? outer : chunk) +
    R"(}}, "chunk_key_encoding": {"name": "default", "configuration": {"separator": )" + separator +
    R"(}}, "fill_value": )" + settings.FillValue + R"(, "codecs": )" +
    (isSharded ? sharding : Codecs3(settings)) + R"(, "attributes": {}})";
}

fs::path ZarrWriter::PathOfChunk(int level, const glm::ivec3& chunk, int channel, int time) const
{
  std::string key = this->Settings.Format == 2 ? "" : std::string("c") + this->Settings.Separator;
  for (const int position : { time, channel, chunk.z, chunk.y })
  {
    key += std::to_string(position) + this->Settings.Separator;
  }
  return this->Folder / std::to_string(level) / (key + std::to_string(chunk.x));
}

std::size_t ZarrWriter::SamplesOfChunk(int level) const
{
  std::size_t samples = static_cast<std::size_t>(this->Settings.ChannelsOfChunk) *
    static_cast<std::size_t>(this->Settings.TimePointsOfChunk);
  for (int axis = 0; axis < 3; ++axis)
  {
    samples *= static_cast<std::size_t>(this->Levels[static_cast<std::size_t>(level)].Chunk[axis]) *
      static_cast<std::size_t>(glm::max(this->Settings.Shard[axis], 1));
  }
  return samples;
}

Bytes ZarrWriter::Encode(const unsigned char* samples, std::size_t bytes) const
{
  Bytes encoded(samples, samples + bytes);
  if (this->Settings.IsBigEndian == IsLittleEndianMachine())
  {
    SwapSampleBytes(this->Settings.Type, encoded.data(), bytes / SizeOf(this->Settings.Type));
  }
  const std::string& compressor = this->Settings.Compressor;
  encoded = compressor.empty() ? encoded
    : IsBlosc(compressor)      ? CompressBlosc(this->Settings, encoded)
    : compressor == "zstd"     ? CompressZstd(this->Settings, encoded)
                               : CompressZlib(this->Settings, encoded);
  if (this->Settings.HasChecksum)
  {
    Append(Crc32c(encoded.data(), encoded.size()), 4, encoded);
  }
  return encoded;
}

Bytes ZarrWriter::EncodeShard(
  const unsigned char* samples, std::size_t bytes, std::size_t count) const
{
  Bytes chunks, index;
  const std::size_t before = this->Settings.IsIndexAtStart ? count * 16 + 4 : 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Bytes chunk = this->Encode(samples + i * bytes, bytes);
    Append(before + chunks.size(), 8, index);
    Append(chunk.size(), 8, index);
    chunks.insert(chunks.end(), chunk.begin(), chunk.end());
  }
  Append(Crc32c(index.data(), index.size()), 4, index);
  Bytes& first = this->Settings.IsIndexAtStart ? index : chunks;
  const Bytes& second = this->Settings.IsIndexAtStart ? chunks : index;
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

bool ZarrWriter::WriteChunk(
  int level, const glm::ivec3& chunk, const void* samples, int channel, int time) const
{
  const glm::ivec3& shard = this->Settings.Shard;
  const bool isSharded = shard.x > 0;
  const std::size_t count =
    isSharded ? static_cast<std::size_t>(shard.x) * static_cast<std::size_t>(shard.y * shard.z) : 1;
  const std::size_t bytes = this->SamplesOfChunk(level) * SizeOf(this->Settings.Type) / count;
  const auto* from = static_cast<const unsigned char*>(samples);
  const Bytes encoded =
    isSharded ? this->EncodeShard(from, bytes, count) : this->Encode(from, bytes);
  return !encoded.empty() &&
    WriteBytes(this->PathOfChunk(level, chunk, channel, time),
      reinterpret_cast<const char*>(encoded.data()), encoded.size());
}

}
