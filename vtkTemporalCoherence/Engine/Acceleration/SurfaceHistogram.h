// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceHistogram_h
#define TemporalCoherence_SurfaceHistogram_h

#include "Scene/Field.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

class ValueRangePyramid;

/// For equal parts of the range of samples, how many blocks of cells hold isovalues of the part:
/// how much surface isovalues have. It needs no samples, so it takes no time for large volumes.
struct SurfaceHistogram
{
  glm::dvec2 Range{ 0.0 };
  std::vector<std::int64_t> Counts; ///< empty if no sample is finite

  /// The isovalue below which a given share of all surfaces lies.
  double IsovalueAt(double share) const;
};

/// \param type of the samples
/// \throws std::bad_alloc
SurfaceHistogram CountSurfaces(
  ScalarType type, const ValueRangePyramid& ranges, std::size_t parts = 256);

}

#endif
