// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellValues_h
#define TemporalCoherence_CellValues_h

#include "Mesh/Tiles/KernelsBoxes.h"

#include <glm/glm.hpp>

#include <array>

namespace TemporalCoherence
{

/// Fit a linear function of the point to a hexahedron's values. Bend is its largest error, infinite
/// in a flat cell. Along a ray in the cell, values exceed the range between the ray's end values by
/// at most twice Bend.
NearlyLinear NearlyLinearOf(
  const std::array<glm::dvec3, 8>& points, const std::array<double, 8>& values);

}

#endif
