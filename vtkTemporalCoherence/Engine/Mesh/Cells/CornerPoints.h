// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CornerPoints_h
#define TemporalCoherence_CornerPoints_h

#include "Mesh/Cells/KernelsCells.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Points of a cell with their differences from the isovalue.
template <std::size_t Number>
struct CornerPoints
{
  std::array<glm::dvec3, Number> Points;
  std::array<double, Number> Values;
  double Handedness = 1.0; ///< of a tetrahedron: the sign of its volume; 1 if it is flat
};

/// Coordinate axes in sheared order, for rays along an axis: x, y, and the axis itself.
inline std::array<glm::length_t, 3> TurnedAxes(std::size_t axis)
{
  const auto z = static_cast<glm::length_t>(axis);
  return { (z + 1) % 3, (z + 2) % 3, z };
}

}
}

#endif
