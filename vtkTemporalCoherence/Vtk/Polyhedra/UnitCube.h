// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UnitCube_h
#define TemporalCoherence_UnitCube_h

#include <glm/glm.hpp>

#include <vector>

namespace TemporalCoherence
{

/// Scale points to the unit cube. Those of a thin set lie there along its principal axes, all
/// extents alike: what is done to them in double precision would lose most of it.
/// \return false if they lie in a plane
bool ScaleToUnit(const std::vector<glm::dvec3>& points, std::vector<glm::dvec3>& scaled);

}

#endif
