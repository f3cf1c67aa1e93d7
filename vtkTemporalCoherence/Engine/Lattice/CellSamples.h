// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellSamples_h
#define TemporalCoherence_CellSamples_h

#include "Scene/Field.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>

namespace TemporalCoherence
{

/// Prefetch the samples of a cell and those around it that its gradients need.
template <typename T>
void PrefetchAround(const TypedField<T>& samples, const glm::ivec3& cell)
{
  const glm::ivec3 last = samples.Dimensions - 1;
  const T* const origin = samples.At(cell);
  for (int k = std::max(cell.z - 1, 0); k <= std::min(cell.z + 2, last.z); ++k)
  {
    for (int j = std::max(cell.y - 1, 0); j <= std::min(cell.y + 2, last.y); ++j)
    {
      hwy::Prefetch(origin + (j - cell.y) * samples.Strides.y + (k - cell.z) * samples.Strides.z);
    }
  }
}

/// Reads the samples at the corners of cells.
template <typename T>
class CellSamples
{
public:
  explicit CellSamples(const Field& field)
    : Samples(field)
  {
    const glm::i64vec3& s = field.Strides;
    this->CornerOffsets = { 0, s.x, s.y, s.x + s.y, s.z, s.x + s.z, s.y + s.z, s.x + s.y + s.z };
  }

  const TypedField<T>& All() const { return this->Samples; }

  /// Corner (x, y, z) at [x + 2 y + 4 z].
  std::array<T, 8> Read(const glm::ivec3& cell) const
  {
    const T* origin = this->Samples.At(cell);
    std::array<T, 8> samples;
    for (std::size_t i = 0; i < 8; ++i)
    {
      samples[i] = origin[this->CornerOffsets[i]];
    }
    return samples;
  }

  /// Prefetch the samples of a cell.
  void Prefetch(const glm::ivec3& cell) const
  {
    const T* const origin = this->Samples.At(cell);
    hwy::Prefetch(origin);
    hwy::Prefetch(origin + this->CornerOffsets[2]);
    hwy::Prefetch(origin + this->CornerOffsets[4]);
    hwy::Prefetch(origin + this->CornerOffsets[6]);
  }

private:
  TypedField<T> Samples;
  std::array<std::int64_t, 8> CornerOffsets;
};

}

#endif
