// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SlabChunk_h
#define TemporalCoherence_SlabChunk_h

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{

/// Divide a volume without chunks into slabs: whole slices, as many as fit. Slices that are too
/// large are divided into rows, and rows that are too long are divided, too.
/// \param dimensions   samples of the volume; positive
/// \param sampleSize   bytes of a sample
/// \param mostOfSlab   bytes of a slab of several slices, at most
/// \param mostOfSlice  bytes of a slab of one slice, at most
/// \return samples of a slab along each axis
inline glm::ivec3 SlabChunk(const glm::ivec3& dimensions, std::size_t sampleSize,
  std::size_t mostOfSlab, std::size_t mostOfSlice)
{
  const auto along = [](std::size_t most, std::size_t one, int all) {
    return static_cast<int>(std::clamp<std::size_t>(most / one, 1, static_cast<std::size_t>(all)));
  };
  glm::ivec3 slab(1);
  slab.x = along(mostOfSlice, sampleSize, dimensions.x);
  const std::size_t row = sampleSize * static_cast<std::size_t>(slab.x);
  slab.y = along(mostOfSlice, row, dimensions.y);
  const std::size_t slice = row * static_cast<std::size_t>(slab.y);
  slab.z = along(mostOfSlab, slice, dimensions.z);
  return slab;
}

}

#endif
