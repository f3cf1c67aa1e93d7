// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ZarrWriter_h
#define TemporalCoherence_ZarrWriter_h

#include "Scene/ScalarType.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// One resolution of a volume to be written.
struct ZarrWriterLevel
{
  glm::ivec3 Dimensions{ 1 }; ///< samples along x, y and z
  glm::ivec3 Chunk{ 1 };      ///< samples of a chunk along x, y and z
  glm::dvec3 Scale{ 1.0 };
  glm::dvec3 Translation{ 0.0 };
};

/// How a volume is written.
struct ZarrWriterSettings
{
  int Format = 2; ///< version of Zarr: 2 with NGFF 0.4, 3 with NGFF 0.5
  ScalarType Type = ScalarType::UInt8;
  bool IsBigEndian = false;
  char Separator = '/';
  std::string Compressor; ///< empty, zlib (2 only), gzip, zstd, or blosc- and its inner compressor
  int Effort = 1;         ///< of the compressor
  int Channels = 1;
  int TimePoints = 1;
  int ChannelsOfChunk = 1;
  int TimePointsOfChunk = 1;
  std::string FillValue = "0"; ///< in JSON
  bool HasChecksum = false;    ///< version 3: CRC-32C after each chunk
  glm::ivec3 Shard{ 0 };       ///< version 3: chunks of a file along x, y and z; 0: no shards
  bool IsIndexAtStart = false; ///< of shards
};

/// Writes an OME-Zarr image. Chunks are written one by one, so a volume may exceed memory.
class ZarrWriter
{
public:
  /// Make the folder with all metadata.
  /// \param folder must not exist, or be empty
  /// \return false if a file cannot be written
  bool Open(const std::filesystem::path& folder, const ZarrWriterSettings& settings,
    const std::vector<ZarrWriterLevel>& levels);

  /// Compress and write a chunk. Thread-safe. Chunks that are not written have the fill value.
  /// \param level   position in the list of levels
  /// \param chunk   position in the grid of chunks. With shards: position in the grid of shards
  /// \param samples all samples of the chunk, x fastest, in this machine's byte order. Channels
  ///                and time points of one chunk follow each other. With shards: all chunks of
  ///                the shard, one after another, that along x first
  /// \param channel position in the grid of chunks along the axis of channels
  /// \param time    position in the grid of chunks along the axis of time
  bool WriteChunk(
    int level, const glm::ivec3& chunk, const void* samples, int channel = 0, int time = 0) const;

  /// Samples that WriteChunk takes.
  std::size_t SamplesOfChunk(int level) const;

  /// The file of a chunk, or of a shard.
  std::filesystem::path PathOfChunk(
    int level, const glm::ivec3& chunk, int channel = 0, int time = 0) const;

private:
  std::string ArrayMetadata(const ZarrWriterLevel& level) const;
  std::string ImageMetadata() const;
  std::vector<unsigned char> Encode(const unsigned char* samples, std::size_t bytes) const;
  std::vector<unsigned char> EncodeShard(
    const unsigned char* samples, std::size_t bytes, std::size_t count) const;

  std::filesystem::path Folder;
  ZarrWriterSettings Settings;
  std::vector<ZarrWriterLevel> Levels;
};

/// Write a whole file.
bool WriteZarrFile(const std::filesystem::path& path, const std::string& contents);

}

#endif
