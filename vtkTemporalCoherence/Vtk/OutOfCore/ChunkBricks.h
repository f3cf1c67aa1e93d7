// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ChunkBricks_h
#define TemporalCoherence_ChunkBricks_h

#include "Bricks/BrickReader.h"
#include "OutOfCore/ChunkCache.h"

#include <cstddef>

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

private:
  ChunkCache& Chunks;
  std::size_t SampleSize;
};

}

#endif
