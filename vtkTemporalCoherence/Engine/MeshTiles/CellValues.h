// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellValues_h
#define TemporalCoherence_CellValues_h

#include "MeshTiles/KernelsBoxes.h"

#include <glm/glm.hpp>

#include <array>

namespace TemporalCoherence
{

/// The values of a hexahedron as a linear function of the point, and how far they are from it at
/// most. Bend is infinite in a flat cell. Where a ray runs from one value to another in the cell,
/// it does not pass any that is more than twice Bend farther beyond both.
NearlyLinear NearlyLinearOf(
  const std::array<glm::dvec3, 8>& points, const std::array<double, 8>& values);

}

#endif
