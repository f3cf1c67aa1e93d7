// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chunks.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <future>
#include <vector>

using TemporalCoherence::ScalarType;

namespace
{

/// Makes rows of chunks. Each thread has its own.
class ChunkMaker
{
public:
  ChunkMaker(const MixingLayer& layer, ScalarType type, const glm::ivec3& chunk)
    : Layer(layer)
    , Type(type)
    , Chunk(chunk)
    , SampleSize(TemporalCoherence::SizeOf(type))
    , Rows(this->BytesOf({ layer.Dimensions().x, chunk.y, chunk.z }))
    , Samples(this->BytesOf(chunk))
  {
  }

  /// Make the chunks at y and z in the grid of chunks.
  bool Row(int y, int z, const TakeChunk& take)
  {
    const glm::ivec3& all = this->Layer.Dimensions();
    const glm::ivec2 size(this->Chunk.y, this->Chunk.z);
    const glm::ivec2 first = glm::ivec2(y, z) * size;
    this->Count = glm::min(size, glm::ivec2(all.y, all.z) - first);
    this->Layer.Rows(first, this->Count, this->Type, this->Rows.data());
    for (int x = 0; x * this->Chunk.x < all.x; ++x)
    {
      this->Cut(x * this->Chunk.x);
      if (!take({ x, y, z }, this->Samples.data()))
      {
        return false;
      }
    }
    return true;
  }

private:
  std::size_t BytesOf(const glm::ivec3& size) const
  {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
      static_cast<std::size_t>(size.z) * this->SampleSize;
  }

  /// Copy the samples of a chunk out of the rows.
  void Cut(int firstX)
  {
    const int all = this->Layer.Dimensions().x;
    const std::size_t bytes = this->BytesOf({ std::min(this->Chunk.x, all - firstX), 1, 1 });
    std::fill(this->Samples.begin(), this->Samples.end(), std::byte(0));
    for (int z = 0; z < this->Count.y; ++z)
    {
      for (int y = 0; y < this->Count.x; ++y)
      {
        const std::size_t from =
          this->BytesOf({ all, z * this->Count.x + y, 1 }) + this->BytesOf({ firstX, 1, 1 });
        const std::size_t to = this->BytesOf({ this->Chunk.x, z * this->Chunk.y + y, 1 });
        std::memcpy(this->Samples.data() + to, this->Rows.data() + from, bytes);
      }
    }
  }

  const MixingLayer& Layer;
  ScalarType Type;
  glm::ivec3 Chunk;
  std::size_t SampleSize;
  glm::ivec2 Count{ 0 }; ///< rows along y and z
  std::vector<std::byte> Rows, Samples;
};

}

bool ForEachChunk(
  const MixingLayer& layer, ScalarType type, const glm::ivec3& chunk, const TakeChunk& take)
{
  const glm::ivec3 grid = (layer.Dimensions() - 1) / chunk + 1;
  std::atomic<int> next{ 0 };
  std::atomic<bool> goesOn{ true };
  const auto work = [&]
  {
    ChunkMaker maker(layer, type, chunk);
    for (int row = next++; row < grid.y * grid.z && goesOn; row = next++)
    {
      if (!maker.Row(row % grid.y, row / grid.y, take))
      {
        goesOn = false;
      }
    }
  };
  std::future<void> other = std::async(std::launch::async, work);
  work();
  other.get();
  return goesOn;
}
