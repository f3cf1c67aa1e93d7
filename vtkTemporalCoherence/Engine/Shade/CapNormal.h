// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CapNormal_h
#define TemporalCoherence_CapNormal_h

#include "Scene/CapPoint.h"
#include "Scene/Field.h"

#include <glm/glm.hpp>

#include <vector>

namespace TemporalCoherence
{

/// The normal of a cap, in index space: of a face of the field, of a face of the hidden cell that
/// the ray comes from, or of a plane that clips the field.
/// \param planes that clip the field: unit normal and offset
/// \return of unit length, facing against the ray; the zero vector if the point is on none of them
glm::dvec3 CapNormal(
  const CapPoint& cap, const Field& field, const std::vector<glm::dvec4>& planes);

}

#endif
