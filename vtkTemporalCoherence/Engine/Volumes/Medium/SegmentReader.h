// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SegmentReader_h
#define TemporalCoherence_SegmentReader_h

#include "Scene/Field.h"
#include "Volumes/Medium/KernelsVolumeSegments.h"

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{

/// Reads the cells that rays pass, and finds the segments there, with values in bins.
template <typename T>
class SegmentReader
{
public:
  /// \param low value at which bins begin
  SegmentReader(const Field& samples, double low, double perValue)
    : Samples(samples)
    , Low(low)
    , PerValue(perValue)
    , Scale{ static_cast<float>(perValue), static_cast<float>(-low * perValue) }
    , AreNarrow(sizeof(T) <= 2 && samples.HasCells() && NarrowSamples<T>::Are(samples))
  {
  }

  float BinOf(T sample) const
  {
    if constexpr (sizeof(T) <= 2)
    {
      // The kernels round in the same way, so samples may lie anywhere in memory.
      return static_cast<float>(sample) * this->Scale.PerValue + this->Scale.Shift;
    }
    else
    {
      return static_cast<float>((static_cast<double>(sample) - this->Low) * this->PerValue);
    }
  }

  /// Append the segments of a row of cells.
  void Find(const SegmentsKernels::CellRow& row, const SegmentsKernels::SeenBins& seen,
    VolumeSegments& segments) const
  {
    if constexpr (sizeof(T) <= 2)
    {
      if (this->AreNarrow)
      {
        SegmentsKernels::FindSegments(
          row, NarrowSamples<T>(this->Samples), this->Scale, seen, segments);
        return;
      }
    }
    SegmentsKernels::CornerValues corners;
    this->ReadCorners(row, corners);
    SegmentsKernels::FindSegments(row, corners, seen, segments);
  }

private:
  void ReadCorners(
    const SegmentsKernels::CellRow& row, SegmentsKernels::CornerValues& corners) const
  {
    const TypedField<T> samples(this->Samples);
    const auto count = static_cast<std::size_t>(row.Walks.Rays.Count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const T* const origin = samples.At(static_cast<int>(row.Cells()[0][i]),
        static_cast<int>(row.Cells()[1][i]), static_cast<int>(row.Cells()[2][i]));
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        const T* const at = origin + ((corner & 1u) != 0 ? samples.Strides.x : 0) +
          ((corner & 2u) != 0 ? samples.Strides.y : 0) +
          ((corner & 4u) != 0 ? samples.Strides.z : 0);
        corners[corner][i] = this->BinOf(*at);
      }
    }
    // Zero the unused lanes of the last vector.
    for (auto& values : corners)
    {
      std::fill(values.begin() + static_cast<std::ptrdiff_t>(count),
        values.begin() + static_cast<std::ptrdiff_t>(WholeVectors(count)), 0.0f);
    }
  }

  const Field& Samples;
  double Low, PerValue;
  SegmentsKernels::BinScale Scale;
  bool AreNarrow;
};

}

#endif
