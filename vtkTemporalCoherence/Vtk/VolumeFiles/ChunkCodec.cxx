// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ChunkCodec.h"

#include <blosc.h>
#include <zlib.h>
#include <zstd.h>

#include <array>
#include <cstring>

namespace TemporalCoherence
{
namespace
{

constexpr const char* OtherSize = "does not have the size that the metadata say";
constexpr const char* Damaged = "is damaged";

bool DecompressBlosc(
  const unsigned char* from, std::size_t size, void* to, std::size_t bytes, std::string& defect)
{
  if (size < BLOSC_MIN_HEADER_LENGTH)
  {
    defect = "is shorter than its header";
    return false;
  }
  std::size_t headerBytes = 0, compressed = 0, block = 0;
  blosc_cbuffer_sizes(from, &headerBytes, &compressed, &block);
  if (compressed != size)
  {
    defect =
      size < compressed ? "is shorter than its header says" : "is longer than its header says";
    return false;
  }
  std::size_t decoded = 0;
  if (blosc_cbuffer_validate(from, size, &decoded) != 0)
  {
    defect = Damaged;
    return false;
  }
  if (decoded != bytes)
  {
    defect = OtherSize;
    return false;
  }
  // One thread for each call: callers read many chunks at once.
  const int result = blosc_decompress_ctx(from, to, bytes, 1);
  defect = Damaged;
  return result >= 0 && static_cast<std::size_t>(result) == bytes;
}

bool DecompressZstd(
  const unsigned char* from, std::size_t size, void* to, std::size_t bytes, std::string& defect)
{
  const std::size_t result = ZSTD_decompress(to, bytes, from, size);
  if (ZSTD_isError(result))
  {
    defect = std::string(Damaged) + " (" + ZSTD_getErrorName(result) + ")";
    return false;
  }
  defect = OtherSize;
  return result == bytes;
}

/// Gzip files may have several members; their contents follow each other.
bool DecompressZlib(
  const unsigned char* from, std::size_t size, void* to, std::size_t bytes, std::string& defect)
{
  constexpr int AnyHeader = 15 + 32;
  z_stream stream{};
  if (inflateInit2(&stream, AnyHeader) != Z_OK)
  {
    defect = "cannot be decompressed for lack of memory";
    return false;
  }
  stream.next_in = const_cast<unsigned char*>(from);
  stream.avail_in = static_cast<uInt>(size);
  stream.next_out = static_cast<unsigned char*>(to);
  stream.avail_out = static_cast<uInt>(bytes);
  int result = inflate(&stream, Z_FINISH);
  while (result == Z_STREAM_END && stream.avail_out > 0 && stream.avail_in > 0)
  {
    result = inflateReset(&stream) == Z_OK ? inflate(&stream, Z_FINISH) : Z_DATA_ERROR;
  }
  const bool isWhole = result == Z_STREAM_END && stream.avail_out == 0;
  defect = result == Z_STREAM_END                   ? OtherSize
    : result == Z_BUF_ERROR && stream.avail_out > 0 ? "ends too early"
    : result == Z_BUF_ERROR                         ? OtherSize
                                                    : Damaged;
  inflateEnd(&stream);
  return isWhole;
}

bool RemoveChecksum(const unsigned char* from, std::size_t& size, std::string& defect)
{
  constexpr std::size_t ChecksumBytes = 4;
  if (size < ChecksumBytes)
  {
    defect = "is shorter than its checksum";
    return false;
  }
  size -= ChecksumBytes;
  std::uint32_t stored = 0;
  for (std::size_t i = 0; i < ChecksumBytes; ++i)
  {
    stored |= static_cast<std::uint32_t>(from[size + i]) << (8 * i);
  }
  defect = "does not match its checksum";
  return stored == Crc32c(from, size);
}

}

std::uint64_t LargestCompressedSize(std::uint64_t decodedBytes)
{
  return decodedBytes + decodedBytes / 64 + 65536;
}

bool Decompress(const ChunkCodec& codec, const unsigned char* from, std::size_t size, void* to,
  std::size_t bytes, std::string& defect)
{
  if (codec.HasChecksum && !RemoveChecksum(from, size, defect))
  {
    return false;
  }
  switch (codec.Compression)
  {
    case ChunkCompression::Blosc:
      return DecompressBlosc(from, size, to, bytes, defect);
    case ChunkCompression::Zstd:
      return DecompressZstd(from, size, to, bytes, defect);
    case ChunkCompression::Zlib:
      return DecompressZlib(from, size, to, bytes, defect);
    case ChunkCompression::None:
      break;
  }
  if (size != bytes)
  {
    defect = OtherSize;
    return false;
  }
  std::memcpy(to, from, bytes);
  return true;
}

std::uint32_t Crc32c(const unsigned char* bytes, std::size_t size)
{
  static const std::array<std::uint32_t, 256> Table = []
  {
    constexpr std::uint32_t Polynomial = 0x82f63b78U;
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i)
    {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit)
      {
        value = value & 1U ? value >> 1 ^ Polynomial : value >> 1;
      }
      table[i] = value;
    }
    return table;
  }();
  std::uint32_t sum = ~0U;
  for (std::size_t i = 0; i < size; ++i)
  {
    sum = sum >> 8 ^ Table[(sum ^ bytes[i]) & 0xffU];
  }
  return ~sum;
}

}
