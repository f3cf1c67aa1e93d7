// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ChunkBricks_h
#define TemporalCoherence_ChunkBricks_h

#include "Bricks/BrickReader.h"
#include "OutOfCore/ChunkCache.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Puts boxes of samples together from the chunks of a volume.
class ChunkBricks : public BrickReader
{
public:
  /// \param chunks     must outlive this
  /// \param sampleSize bytes of a sample
  ChunkBricks(ChunkCache& chunks, std::size_t sampleSize)
    : Chunks(chunks)
    , SampleSize(sampleSize)
  {
  }

  void Read(const glm::ivec3& first, const glm::ivec3& size, void* samples,
    const glm::i64vec2& strides) const override;

  /// Read the whole level.
  /// \param samples room for it, x fastest
  void ReadAll(void* samples) const
  {
    const glm::ivec3& size = this->Chunks.Level().Dimensions;
    this->Read(
      glm::ivec3(0), size, samples, { size.x, static_cast<std::int64_t>(size.x) * size.y });
  }

private:
  ChunkCache& Chunks;
  std::size_t SampleSize;
};

}

#endif
