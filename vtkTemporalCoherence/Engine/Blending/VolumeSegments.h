// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumeSegments_h
#define TemporalCoherence_VolumeSegments_h

#include "Scene/RayBatch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Parts of cell segments in which something may be seen, those of a ray from front to back, and in
/// rows: in each, rays ascend. Values are counted in bins (TransferTables).
struct VolumeSegments
{
  static constexpr std::size_t Capacity = 2 * RayBatch::Capacity;

  /// Vectors are stored from any place on.
  template <typename T>
  struct alignas(64) Array : std::array<T, Capacity + WidestVector>
  {
  };

  /// True if there is no room for a segment of each ray.
  bool IsFull() const
  {
    return static_cast<std::size_t>(this->Count) > Capacity - RayBatch::Capacity;
  }

  /// Where a vector ends that begins with a segment: before a ray comes a second time.
  std::size_t EndOfVector(std::size_t first, std::size_t lanes) const
  {
    const std::size_t last = std::min(first + lanes, static_cast<std::size_t>(this->Count));
    std::size_t end = first + 1;
    while (end<last&& this->Ray[end]> this->Ray[end - 1])
    {
      ++end;
    }
    // Of the next row only rays before the first one.
    for (std::size_t row = end; end < last && this->Ray[end] < this->Ray[first] &&
         (end == row || this->Ray[end] > this->Ray[end - 1]);)
    {
      ++end;
    }
    return end;
  }

  int Count = 0;
  Array<std::int32_t> Ray;
  std::array<Array<std::int32_t>, 3> Cell; ///< its first corner, by axis

  Array<float> Enter;                 ///< t from where the ray begins
  Array<float> Length;                ///< in the world
  std::array<Array<float>, 3> Begin;  ///< where the ray enters, in the coordinates of the cell
  std::array<Array<float>, 3> Across; ///< from there to where it leaves
  std::array<Array<float>, 4> Cubic;  ///< the field at share x: the sum of Cubic[i] x^i
  Array<float> Middle;                ///< between bounds of the field
  Array<float> Span;                  ///< from there to the bounds
  Array<float> Bend;                  ///< the largest second difference of its Bernstein points
};

/// The samples around the cells of segments: the cell's own rows along x, each with the sample
/// before it and the one behind it, [y + 2 z]; and the rows beside the cell, [0, 1] before it in y,
/// [2, 3] behind it, at both z; [4, 5] before it in z, [6, 7] behind it, at both y.
struct SamplesAround
{
  template <typename T>
  using Array = VolumeSegments::Array<T>;

  std::array<std::array<Array<float>, 4>, 4> Along;
  std::array<std::array<Array<float>, 2>, 8> Beside;
};

}

#endif
