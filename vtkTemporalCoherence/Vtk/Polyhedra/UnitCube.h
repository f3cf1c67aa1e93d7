// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UnitCube_h
#define TemporalCoherence_UnitCube_h

#include <glm/glm.hpp>

#include <vector>

namespace TemporalCoherence
{

/// Scale points to the unit cube. A thin set is turned to its principal axes and stretched to equal
/// extents: otherwise, work in double precision would lose most of its shape.
/// \return false if the points lie in a plane
bool ScaleToUnit(const std::vector<glm::dvec3>& points, std::vector<glm::dvec3>& scaled);

}

#endif
