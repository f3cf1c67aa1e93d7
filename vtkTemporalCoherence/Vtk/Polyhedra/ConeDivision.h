// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ConeDivision_h
#define TemporalCoherence_ConeDivision_h

#include "Polyhedra/ClosedSurface.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A part of a cell: the cone from an apex over a base. Both may use points inside of the cell.
struct Cone
{
  SurfacePart Base;
  std::int32_t Apex;
};

/// The division of a cell into cones, which fill the cell exactly once.
struct ConeDivision
{
  /// For each inner point, the weight of each given point. The weights add up to 1. Numbers of
  /// inner points follow the numbers of given points.
  std::vector<std::vector<double>> Inside;
  std::vector<Cone> Cones;
};

/// Budget of divisions, in compared pairs of parts.
struct DivisionWork
{
  std::int64_t OfOne = std::int64_t(1) << 25;    ///< for one cell: about a second
  std::int64_t OfFailed = std::int64_t(1) << 27; ///< for the failed divisions of all cells together
  std::int64_t Afterwards = std::int64_t(1) << 15; ///< for each cell once that is spent; some ms
};

/// Divide a cell into cones over parts of its surface, and over triangles inside.
///
/// If a point sees the whole surface, it becomes the apex of one cone over each part. Otherwise the
/// best of several points becomes the apex of cones over the parts that it sees. These cones are
/// cut off, and the rest is divided likewise.
///
/// \param points  in the unit cube
/// \param surface closed, and turned outwards
/// \param work    loses the cost of a failed division
/// \return false if no division was found
bool DivideIntoCones(const std::vector<glm::dvec3>& points, const std::vector<SurfacePart>& surface,
  DivisionWork& work, ConeDivision& division);

}

#endif
