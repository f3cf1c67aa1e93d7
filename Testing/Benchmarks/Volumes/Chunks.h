// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Chunks_h
#define Benchmarks_Chunks_h

#include "MixingLayer.h"

#include <functional>

/// Takes the samples of a whole chunk, x fastest. Samples beyond the end of the volume are 0.
/// \param chunk position in the grid of chunks
/// \return false to stop
using TakeChunk = std::function<bool(const glm::ivec3& chunk, const void* samples)>;

/// Make a volume chunk by chunk, by two threads. Each keeps one row of chunks in memory.
/// \param chunk samples of a chunk along each axis; positive
/// \param take  is called by both threads at once
/// \return false if `take` stopped
bool ForEachChunk(const MixingLayer& layer, TemporalCoherence::ScalarType type,
  const glm::ivec3& chunk, const TakeChunk& take);

#endif
