// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumeSegments_h
#define TemporalCoherence_VolumeSegments_h

#include "Scene/RayBatch.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// Cell segments in which something may be seen, at most one of each ray of a tile. Values are
/// counted in bins (TransferTables).
struct VolumeSegments
{
  /// Vectors are stored from any place on.
  template <typename T>
  struct alignas(64) Array : std::array<T, RayBatch::Capacity + WidestVector>
  {
  };

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
  using Array = RayBatch::Array<T>;

  std::array<std::array<Array<float>, 4>, 4> Along;
  std::array<std::array<Array<float>, 2>, 8> Beside;
};

}

#endif
