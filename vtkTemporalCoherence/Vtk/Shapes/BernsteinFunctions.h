// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BernsteinFunctions_h
#define TemporalCoherence_BernsteinFunctions_h

#include "Shapes/StraightCell.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace TemporalCoherence
{

/// The functions of Bezier cells: products of powers of barycentric coordinates in simplices, and
/// of Bernstein polynomials along axes. VTK evaluates equal functions by recursion.
class BernsteinFunctions
{
public:
  BernsteinFunctions() = default;

  /// \param places of the control points in the straight cell
  /// \param powers along its axes
  BernsteinFunctions(
    CurvedShape shape, const std::vector<glm::dvec3>& places, const std::array<int, 3>& powers);

  /// False if the control points do not lie at equal distances.
  bool AreKnown() const { return !this->Functions.empty(); }

  /// The values of all functions at a place.
  void At(const glm::dvec3& place, double* values) const;

private:
  /// A factor times powers of up to six variables.
  struct Function
  {
    double Factor;
    std::array<int, 6> Powers;
  };

  CurvedShape Shape = CurvedShape::Hexahedron;
  std::vector<Function> Functions; ///< of each point
};

}

#endif
