// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellCuts_h
#define TemporalCoherence_CellCuts_h

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace TemporalCoherence
{

/// Find the corners of the polygon in which the surface with value 0 cuts a tetrahedron. A triangle
/// repeats its last corner.
/// \pre some values are negative, some are not
void FindPolygon(
  const glm::dvec3* points, const std::array<double, 4>& values, glm::dvec3* polygon);

/// A tetrahedron's part between two planes has no more corners.
constexpr std::size_t MostSlabPoints = 8;

/// Find the corners of a tetrahedron's part with values within bounds. Copies of the first corner
/// fill up the list.
/// \pre the tetrahedron has values within bounds
void FindSlab(const glm::dvec3* points, const std::array<double, 4>& values,
  const glm::dvec2& bounds, glm::dvec3* slab);

/// A hexahedron has no more pairs of corners on different sides of a surface.
constexpr std::size_t MostHullPoints = 16;

/// Points whose convex hull holds the surface in a hexahedron: cuts of the surface with the lines
/// between corners on different sides. Proof: a point of the cell is a weighted mean of corners. At
/// value 0, its weights split into pairs of corners on different sides, each with mean value 0. If
/// the surface nearly passes a corner, returns all corners.
/// \pre some values are negative, some are not
std::array<glm::dvec3, MostHullPoints> HullOf(
  const std::array<glm::dvec3, 8>& points, const std::array<double, 8>& values);

}

#endif
