// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MadeVolumes_h
#define TemporalCoherence_MadeVolumes_h

#include "MixingLayer.h"
#include "RawFiles.h"
#include "VolumeWriters.h"

/// \file
/// Volumes of MakeVolume for tests.

namespace TemporalCoherence
{

/// A volume of three levels, whose chunks reach beyond it.
inline VolumeOrder SmallOrder(const std::string& path)
{
  VolumeOrder order;
  order.Path = path;
  order.Dimensions = { 301, 37, 45 };
  order.Chunk = 32;
  return order;
}

/// True if the samples of a chunk that are in the volume are those of the formula.
inline bool IsChunkOfLayer(const VolumeFile& file, std::size_t number, const glm::ivec3& chunk,
  const std::vector<char>& made)
{
  const VolumeLevel& level = file.Levels()[number];
  const std::size_t size = SizeOf(file.Type());
  std::vector<char> read(level.SamplesOfChunk() * size);
  std::string error;
  if (!file.ReadChunk(number, chunk, read.data(), error))
  {
    ADD_FAILURE() << error;
    return false;
  }
  const auto bytesTo = [size](const glm::ivec3& place, const glm::ivec3& room)
  { return size * static_cast<std::size_t>(place.x + room.x * (place.y + room.y * place.z)); };
  const glm::ivec3 first = chunk * level.Chunk;
  const glm::ivec3 inside = glm::min(level.Chunk, level.Dimensions - first);
  for (int z = 0; z < inside.z; ++z)
  {
    for (int y = 0; y < inside.y; ++y)
    {
      const char* const one = read.data() + bytesTo({ 0, y, z }, level.Chunk);
      const char* const other =
        made.data() + bytesTo(first + glm::ivec3(0, y, z), level.Dimensions);
      if (std::memcmp(one, other, size * static_cast<std::size_t>(inside.x)) != 0)
      {
        return false;
      }
    }
  }
  return true;
}

/// Compare all levels of a volume with the formula. Each takes the same room.
inline void ExpectLayer(const VolumeFile& file, const VolumeOrder& order)
{
  ASSERT_EQ(file.Type(), order.Type);
  ASSERT_EQ(file.Levels().size(), static_cast<std::size_t>(NumberOfLevels(order.Dimensions)));
  for (std::size_t number = 0; number < file.Levels().size(); ++number)
  {
    const VolumeLevel& level = file.Levels()[number];
    ASSERT_EQ(level.Dimensions, SizeOfLevel(order.Dimensions, static_cast<int>(number)));
    ASSERT_EQ(level.Chunk, glm::ivec3(order.Chunk));
    const glm::dvec3 size(level.Dimensions);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(level.Origin[axis] - 0.5 * level.Spacing[axis], -0.5, 1e-6);
      EXPECT_NEAR(level.Spacing[axis] * size[axis], order.Dimensions[axis], 1e-4);
    }
    std::vector<char> made(SizeOf(order.Type) *
      static_cast<std::size_t>(level.Dimensions.x * level.Dimensions.y * level.Dimensions.z));
    MixingLayer(level.Dimensions).Slices(0, level.Dimensions.z, order.Type, made.data());
    const glm::ivec3 grid = level.NumberOfChunks();
    for (int i = 0; i < grid.x * grid.y * grid.z; ++i)
    {
      const glm::ivec3 chunk(i % grid.x, i / grid.x % grid.y, i / grid.x / grid.y);
      ASSERT_TRUE(IsChunkOfLayer(file, number, chunk, made)) << "level " << number << ", " << i;
    }
  }
}

}

#endif
