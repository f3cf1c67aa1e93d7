// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chunks.h"
#include "VolumeWriters.h"

#include "VolumeFiles/Hdf5Writer.h"

#include <zlib.h>

#include <mutex>
#include <vector>

using namespace TemporalCoherence;

namespace
{

constexpr int Effort = 2; // that of Imaris

using Bytes = std::vector<unsigned char>;

/// \return no bytes on error
Bytes Deflated(const void* samples, std::size_t bytes)
{
  uLongf size = compressBound(static_cast<uLong>(bytes));
  Bytes to(size);
  const int result = compress2(
    to.data(), &size, static_cast<const Bytef*>(samples), static_cast<uLong>(bytes), Effort);
  to.resize(result == Z_OK ? size : 0);
  return to;
}

Hdf5Plan MakePlan(const VolumeOrder& order)
{
  Hdf5Plan plan;
  plan.Layout = Hdf5Layout::Imaris;
  plan.Type = order.Type;
  plan.Chunk = glm::ivec3(order.Chunk);
  plan.Deflate = order.Codec == "none" ? -1 : Effort;
  plan.BoxMin = glm::dvec3(-0.5);
  plan.BoxMax = glm::dvec3(order.Dimensions) - 0.5;
  for (int level = 0; level < NumberOfLevels(order.Dimensions); ++level)
  {
    plan.Dimensions.push_back(SizeOfLevel(order.Dimensions, level));
  }
  return plan;
}

/// Compress a level by two threads, and write it by one at a time, as the library does no more.
bool WriteLevel(Hdf5Writer& writer, const Hdf5Plan& plan, std::size_t level)
{
  const auto side = static_cast<std::size_t>(plan.Chunk.x);
  const std::size_t bytes = side * side * side * SizeOf(plan.Type);
  std::mutex mutex;
  const auto take = [&](const glm::ivec3& chunk, const void* samples)
  {
    if (plan.Deflate < 0)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      return writer.WriteChunk(level, chunk, samples);
    }
    const Bytes stored = Deflated(samples, bytes);
    const std::lock_guard<std::mutex> lock(mutex);
    return !stored.empty() && writer.WriteStoredChunk(level, chunk, stored.data(), stored.size());
  };
  return ForEachChunk(MixingLayer(plan.Dimensions[level]), plan.Type, plan.Chunk, take);
}

}

bool WriteImaris(const VolumeOrder& order, std::string& error)
{
  if (!order.Codec.empty() && order.Codec != "none" && order.Codec != "gzip")
  {
    error = "The codec '" + order.Codec + "' of Imaris is unknown; use none or gzip.";
    return false;
  }
  // The library would print its own errors.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Hdf5Plan plan = MakePlan(order);
  Hdf5Writer writer(order.Path, plan);
  bool isWritten = writer.IsGood();
  for (std::size_t level = 0; isWritten && level < plan.Dimensions.size(); ++level)
  {
    isWritten = WriteLevel(writer, plan, level);
  }
  error = isWritten && writer.Close()
    ? std::string()
    : "Cannot write '" + order.Path + "'; check the folder and the room on its disk.";
  return error.empty();
}
