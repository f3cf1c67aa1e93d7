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

/// A part of a cell: what lies between a point and a base, which may have points inside, too.
struct Cone
{
  SurfacePart Base;
  std::int32_t Apex;
};

/// A cell as cones, which fill it once and do not leave it.
struct ConeDivision
{
  /// For each point inside, the weight of each given point. The weights add up to 1. The first
  /// point inside has the number that follows those of the given points.
  std::vector<std::vector<double>> Inside;
  std::vector<Cone> Cones;
};

/// What divisions may cost, in pairs of parts that are compared.
struct DivisionWork
{
  std::int64_t OfOne = std::int64_t(1) << 25;      ///< about a second
  std::int64_t OfFailed = std::int64_t(1) << 27;   ///< in vain, for all cells together
  std::int64_t Afterwards = std::int64_t(1) << 15; ///< for each cell; some milliseconds
};

/// Divide a cell into cones over parts of its surface, and over triangles inside.
///
/// A point that sees the whole surface is searched, so that one cone over each part does. Where
/// there is none, the point of several that sees most gets the cones over what it sees. These are
/// cut off, and the rest is divided in the same way.
///
/// \param points  in the unit cube
/// \param surface closes, and is turned outwards
/// \param work    is told what was in vain
/// \return false if no division was found
bool DivideIntoCones(const std::vector<glm::dvec3>& points, const std::vector<SurfacePart>& surface,
  DivisionWork& work, ConeDivision& division);

}

#endif
