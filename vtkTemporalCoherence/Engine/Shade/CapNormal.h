// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CapNormal_h
#define TemporalCoherence_CapNormal_h

#include "Scene/Field.h"

#include <glm/glm.hpp>

#include <vector>

namespace TemporalCoherence
{

/// Normal, in index space, of the plane on which a ray finds a solid cut open: a face of the field,
/// that of a hidden cell that the ray comes from, or a plane that clips the field. It points
/// against the ray, and has unit length. \param point, direction of the ray, in index space \param
/// planes      planes: normal of unit length, and offset \return the zero vector if the point is on
/// none of them
glm::dvec3 CapNormal(const glm::dvec3& point, const glm::dvec3& direction, const Field& field,
  const std::vector<glm::dvec4>& planes);

}

#endif
