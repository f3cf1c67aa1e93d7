// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCorners_h
#define TemporalCoherence_KernelsCorners_h

#include "Scene/Difference.h"
#include "Scene/Field.h"
#include "Scene/RayBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The samples at the corners of cells, in pairs along x as they lie in memory: [y + 2 z].
template <typename T>
using CornerPairs = std::array<RayBatch::Array<std::array<T, 2>>, 4>;

/// Differences at the corners of cells: [x + 2 y + 4 z].
template <typename Real>
using CornerColumns = std::array<RayBatch::Array<Real>, 8>;

/// The first corners of cells, by axis.
using CellColumns = std::array<RayBatch::Array<std::int32_t>, 3>;

/// Find the differences of narrow integers from an isovalue, in the widest vectors of the machine,
/// bit-identical to Difference.h. Pairs are read, and differences written, up to the end of the
/// last vector.
/// \param high, low the isovalue as the sum of two numbers
void SubtractFrom(const CornerPairs<std::uint8_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners);
void SubtractFrom(const CornerPairs<std::int8_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners);
void SubtractFrom(const CornerPairs<std::uint16_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners);
void SubtractFrom(const CornerPairs<std::int16_t>& pairs, std::size_t count, float high, float low,
  CornerColumns<float>& corners);

/// Find differences at corners by gathering samples directly from memory.
/// \param cells by axis, up to the capacity of batches
/// \return false if some cell's samples cannot be gathered; nothing is written then
bool GatherDifferences(const NarrowSamples<std::uint8_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners);
bool GatherDifferences(const NarrowSamples<std::int8_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners);
bool GatherDifferences(const NarrowSamples<std::uint16_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners);
bool GatherDifferences(const NarrowSamples<std::int16_t>& samples, const CellColumns& cells,
  int samplesAlongX, float high, float low, CornerColumns<float>& corners);

/// Find differences at corners from samples of any type.
template <typename T>
void FindDifferences(const CornerPairs<T>& pairs, std::size_t count,
  const Difference<T>& difference, CornerColumns<RealOf<T>>& corners)
{
  if constexpr (sizeof(T) <= 2)
  {
    const std::array<double, 3> parts = difference.Parts();
    SubtractFrom(pairs, count, static_cast<float>(parts[0]), static_cast<float>(parts[1]), corners);
  }
  else
  {
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        corners[corner][i] = difference(pairs[corner / 2][i][corner % 2]);
      }
    }
  }
}

}

#endif
