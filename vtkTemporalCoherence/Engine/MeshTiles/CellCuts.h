// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellCuts_h
#define TemporalCoherence_CellCuts_h

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace TemporalCoherence
{

/// The corners of the polygon in which a tetrahedron is cut where its values are 0. A triangle ends
/// with its last corner twice.
/// \pre some values are negative, some are not
void FindPolygon(
  const glm::dvec3* points, const std::array<double, 4>& values, glm::dvec3* polygon);

/// A tetrahedron's part between two planes has no more corners.
constexpr std::size_t MostSlabPoints = 8;

/// The corners of the part of a tetrahedron whose values are within bounds. The first one fills up
/// the list.
/// \pre some values of the tetrahedron are
void FindSlab(const glm::dvec3* points, const std::array<double, 4>& values,
  const glm::dvec2& bounds, glm::dvec3* slab);

/// A hexahedron has no more pairs of corners on different sides of a surface.
constexpr std::size_t MostHullPoints = 16;

/// Points around the surface in a hexahedron: where it cuts the lines between corners on different
/// sides. A point of the cell is a mean of corners, with weights that are products; where the mean
/// of the values is 0, the weights can be split among such pairs so that it is 0 in each. All
/// corners, where the surface nearly passes one.
/// \pre some values are negative, some are not
std::array<glm::dvec3, MostHullPoints> HullOf(
  const std::array<glm::dvec3, 8>& points, const std::array<double, 8>& values);

}

#endif
