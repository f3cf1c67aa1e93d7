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

/// Visible parts of cell segments. The parts of each ray run from front to back. They form rows, in
/// which rays ascend. Values are counted in bins (TransferTables).
struct VolumeSegments
{
  static constexpr std::size_t Capacity = 4 * RayBatch::Capacity;

  /// Has room for a whole vector behind any place.
  template <typename T>
  struct alignas(64) Array : std::array<T, Capacity + WidestVector>
  {
  };

  /// True if a further segment of each ray does not fit.
  bool IsFull() const
  {
    return static_cast<std::size_t>(this->Count) > Capacity - RayBatch::Capacity;
  }

  /// The end of the vector that begins with `first`: before a ray occurs a second time.
  std::size_t EndOfVector(std::size_t first, std::size_t lanes) const
  {
    const std::size_t last = std::min(first + lanes, static_cast<std::size_t>(this->Count));
    std::size_t end = first + 1;
    while (end<last&& this->Ray[end]> this->Ray[end - 1])
    {
      ++end;
    }
    // From the next row, take only rays before the first one.
    for (std::size_t row = end; end < last && this->Ray[end] < this->Ray[first] &&
         (end == row || this->Ray[end] > this->Ray[end - 1]);)
    {
      ++end;
    }
    return end;
  }

  /// Zero the unused lanes of the last vector.
  void FillLastVector()
  {
    const auto fill = [this](auto& array)
    { std::fill_n(array.begin() + static_cast<std::ptrdiff_t>(this->Count), WidestVector, 0); };
    const auto fillAll = [&](auto& arrays)
    {
      for (auto& array : arrays)
      {
        fill(array);
      }
    };
    fill(this->Ray);
    fillAll(this->Cell);
    fill(this->Enter);
    fill(this->Length);
    fillAll(this->Begin);
    fillAll(this->Across);
    fillAll(this->Cubic);
    fill(this->Middle);
    fill(this->Span);
    fill(this->Bend);
  }

  int Count = 0;
  Array<std::int32_t> Ray;
  std::array<Array<std::int32_t>, 3> Cell; ///< first corner of the cell, by axis; or see HardQueue

  Array<float> Enter;                 ///< t from the ray's Begin
  Array<float> Length;                ///< in the world
  std::array<Array<float>, 3> Begin;  ///< where the ray enters, in the coordinates of the cell
  std::array<Array<float>, 3> Across; ///< from there to the exit
  std::array<Array<float>, 4> Cubic;  ///< the field at share x: the sum of Cubic[i] x^i
  Array<float> Middle;                ///< of the bounds of the field
  Array<float> Span;                  ///< from the middle to the bounds
  Array<float> Bend;                  ///< the largest second difference of its Bernstein points
};

}

#endif
