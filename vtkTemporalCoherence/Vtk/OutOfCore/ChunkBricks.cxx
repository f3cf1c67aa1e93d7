// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/ChunkBricks.h"

#include <cstddef>
#include <cstring>

namespace TemporalCoherence
{
namespace
{

/// A box of samples in memory.
template <typename Byte>
struct SampleBlock
{
  Byte* First;
  glm::i64vec2 Strides; ///< samples from one to the next along y and z
};

template <std::size_t SampleSize>
void Copy(const SampleBlock<const std::byte>& from, const SampleBlock<std::byte>& to,
  const glm::ivec3& size)
{
  const auto row = static_cast<std::size_t>(size.x) * SampleSize;
  constexpr auto bytes = static_cast<std::int64_t>(SampleSize);
  for (int z = 0; z < size.z; ++z)
  {
    for (int y = 0; y < size.y; ++y)
    {
      std::memcpy(to.First + bytes * (y * to.Strides.x + z * to.Strides.y),
        from.First + bytes * (y * from.Strides.x + z * from.Strides.y), row);
    }
  }
}

}

void ChunkBricks::Read(
  const glm::ivec3& first, const glm::ivec3& size, void* samples, const glm::i64vec2& strides) const
{
  const glm::ivec3& chunk = this->Chunks.Level().Chunk;
  const glm::ivec3 begin = first / chunk, last = (first + size - 1) / chunk;
  const auto bytes = static_cast<std::int64_t>(this->SampleSize);
  for (int z = begin.z; z <= last.z; ++z)
  {
    for (int y = begin.y; y <= last.y; ++y)
    {
      for (int x = begin.x; x <= last.x; ++x)
      {
        const glm::ivec3 origin = chunk * glm::ivec3(x, y, z);
        const glm::ivec3 low = glm::max(first, origin);
        const glm::ivec3 part = glm::min(first + size, origin + chunk) - low;
        const auto read = this->Chunks.Get({ x, y, z });
        const glm::i64vec3 inChunk(low - origin), inBox(low - first);
        const glm::i64vec2 along(chunk.x, static_cast<std::int64_t>(chunk.x) * chunk.y);
        const SampleBlock<const std::byte> from = {
          read.get() + bytes * (inChunk.x + along.x * inChunk.y + along.y * inChunk.z), along
        };
        const SampleBlock<std::byte> to = { static_cast<std::byte*>(samples) +
            bytes * (inBox.x + strides.x * inBox.y + strides.y * inBox.z),
          strides };
        const auto copy = bytes == 1 ? Copy<1>
          : bytes == 2               ? Copy<2>
          : bytes == 4               ? Copy<4>
                                     : Copy<8>;
        copy(from, to, part);
      }
    }
  }
}

}
