// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ZarrChunk.h"

#include <cstring>
#include <limits>
#include <memory>

namespace TemporalCoherence
{
namespace
{

/// Bytes of a file that hold a chunk.
struct FileRange
{
  std::uint64_t First = 0;
  std::uint64_t Bytes = 0;
};

std::uint64_t Integer64(const unsigned char* bytes, bool isBigEndian)
{
  std::uint64_t value = 0;
  for (int i = 0; i < 8; ++i)
  {
    value = value << 8 | bytes[isBigEndian ? i : 7 - i];
  }
  return value;
}

/// Look up a chunk in the index of its file.
/// \return Missing if the file has no such chunk
FileState FindInShard(const ZarrShard& shard, const ZarrChunkPlace& place, ContainedFile& file,
  FileRange& range, std::string& error)
{
  constexpr std::size_t EntryBytes = 16;
  constexpr std::uint64_t NoChunk = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t indexBytes =
    std::uint64_t(shard.Count) * EntryBytes + (shard.HasIndexChecksum ? 4 : 0);
  const std::uint64_t index =
    shard.IsIndexAtStart || file.Size() < indexBytes ? 0 : file.Size() - indexBytes;
  unsigned char entry[EntryBytes];
  if (file.Size() < indexBytes ||
    !file.Read(index + std::uint64_t(place.InFile) * EntryBytes, EntryBytes, entry))
  {
    error = "File " + place.Path.string() + " is too short for its index; copy the volume again.";
    return FileState::Refused;
  }
  range.First = Integer64(entry, shard.IsIndexBigEndian);
  range.Bytes = Integer64(entry + 8, shard.IsIndexBigEndian);
  if (range.First == NoChunk && range.Bytes == NoChunk)
  {
    return FileState::Missing;
  }
  if (range.First > file.Size() || range.Bytes > file.Size() - range.First)
  {
    error = "File " + place.Path.string() +
      " has an index that points behind the file's end; copy the volume again.";
    return FileState::Refused;
  }
  return FileState::Opened;
}

std::string ChunkError(const std::filesystem::path& path, const std::string& defect)
{
  return "Chunk " + path.string() + ' ' + defect + "; copy the volume again.";
}

/// Uninitialized memory. A vector would write zeros first.
std::unique_ptr<unsigned char[]> Room(std::size_t bytes)
{
  return std::unique_ptr<unsigned char[]>(new unsigned char[bytes]);
}

/// Read and decode a chunk of a file. The samples keep the file's byte order.
bool DecodeChunk(const ZarrLevel& level, const std::filesystem::path& path, const FileRange& range,
  ContainedFile& file, void* samples, std::string& error)
{
  const ZarrArray& array = level.Array;
  const bool isPlain =
    array.Codec.Compression == ChunkCompression::None && !array.Codec.HasChecksum;
  if (isPlain ? range.Bytes != array.ChunkBytes
              : range.Bytes > LargestCompressedSize(array.ChunkBytes))
  {
    error = ChunkError(path, "does not have the size that the metadata say");
    return false;
  }
  const auto first = isPlain ? range.First + level.FirstByte : range.First;
  const auto bytes = isPlain ? level.VolumeBytes : static_cast<std::size_t>(range.Bytes);
  const auto packed = isPlain ? nullptr : Room(bytes);
  if (!file.Read(first, bytes, isPlain ? samples : packed.get()))
  {
    error = "Chunk " + path.string() + " cannot be read; check its disk.";
    return false;
  }
  if (isPlain)
  {
    return true;
  }
  const bool isWhole = level.VolumeBytes == array.ChunkBytes;
  const auto whole = isWhole ? nullptr : Room(array.ChunkBytes);
  std::string defect;
  if (!Decompress(array.Codec, packed.get(), bytes, isWhole ? samples : whole.get(),
        array.ChunkBytes, defect))
  {
    error = ChunkError(path, defect);
    return false;
  }
  if (!isWhole)
  {
    std::memcpy(samples, whole.get() + level.FirstByte, level.VolumeBytes);
  }
  return true;
}

}

bool ReadZarrChunk(const ContainedFolder& root, const ZarrLevel& level, const glm::ivec3& chunk,
  void* samples, std::string& error)
{
  const ZarrArray& array = level.Array;
  const ZarrChunkPlace place = PlaceOfChunk(level, chunk);
  ContainedFile file;
  FileState state = file.Open(root, place.Path, error);
  FileRange range;
  range.Bytes = file.Size();
  if (state == FileState::Opened && !array.Shard.Chunks.empty())
  {
    state = FindInShard(array.Shard, place, file, range, error);
  }
  const std::size_t count = level.VolumeBytes / SizeOf(array.Type);
  if (state == FileState::Missing)
  {
    FillSamples(array.Type, array.FillValue, samples, count);
    return true;
  }
  if (state == FileState::Refused || !DecodeChunk(level, place.Path, range, file, samples, error))
  {
    return false;
  }
  if (array.Codec.SwapBytes)
  {
    SwapSampleBytes(array.Type, samples, count);
  }
  return true;
}

}
