// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chunks.h"
#include "VolumeWriters.h"

#include "VolumeFiles/ZarrWriter.h"

#include <filesystem>
#include <system_error>

using namespace TemporalCoherence;

namespace
{

/// \return false if the codec is unknown
bool ChooseCompressor(const std::string& codec, ZarrWriterSettings& settings)
{
  settings.Effort = 5;
  settings.Compressor = codec.empty() ? "blosc-lz4" : codec == "none" ? "" : codec;
  for (const char* known : { "", "blosc-lz4", "blosc-zstd", "zstd", "gzip" })
  {
    if (settings.Compressor == known)
    {
      return true;
    }
  }
  return false;
}

/// A level whose samples are at the centres of cells: all levels take the same room.
ZarrWriterLevel MakeLevel(const VolumeOrder& order, int number)
{
  ZarrWriterLevel level;
  level.Dimensions = SizeOfLevel(order.Dimensions, number);
  level.Chunk = glm::ivec3(order.Chunk);
  level.Scale = glm::dvec3(order.Dimensions) / glm::dvec3(level.Dimensions);
  level.Translation = 0.5 * (level.Scale - 1.0);
  return level;
}

}

bool WriteZarr(const VolumeOrder& order, std::string& error)
{
  ZarrWriterSettings settings;
  settings.Type = order.Type;
  if (!ChooseCompressor(order.Codec, settings))
  {
    error = "The codec '" + order.Codec +
      "' of Zarr is unknown; use none, blosc-lz4, blosc-zstd, zstd or gzip.";
    return false;
  }
  const std::filesystem::path folder = std::filesystem::u8path(order.Path);
  std::error_code failure;
  if (std::filesystem::exists(folder, failure) && !std::filesystem::is_empty(folder, failure))
  {
    error = "'" + order.Path + "' is there already; delete it or give another name.";
    return false;
  }
  std::vector<ZarrWriterLevel> levels;
  for (int number = 0; number < NumberOfLevels(order.Dimensions); ++number)
  {
    levels.push_back(MakeLevel(order, number));
  }
  ZarrWriter writer;
  bool isWritten = writer.Open(folder, settings, levels);
  for (int number = 0; isWritten && number < static_cast<int>(levels.size()); ++number)
  {
    const ZarrWriterLevel& level = levels[static_cast<std::size_t>(number)];
    isWritten = ForEachChunk(MixingLayer(level.Dimensions), order.Type, level.Chunk,
      [&](const glm::ivec3& chunk, const void* samples)
      { return writer.WriteChunk(number, chunk, samples); });
  }
  error = isWritten
    ? std::string()
    : "Cannot write '" + order.Path + "'; check the folder and the room on its disk.";
  return isWritten;
}
