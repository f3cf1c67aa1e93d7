// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CapNormal_h
#define TemporalCoherence_CapNormal_h

#include "Scene/CapPoint.h"
#include "Scene/Field.h"
#include "Scene/View.h"
#include "Shade/FieldNormals.h"

#include <glm/glm.hpp>

#include <vector>

namespace TemporalCoherence
{

/// Planes in index space where solids are capped, as unit normals and offsets.
struct CapPlanes
{
  std::vector<glm::dvec4> OfRegion; ///< planes that clip the field
  glm::dvec4 Near{ 0.0 };           ///< of the camera; 0: there is none

  CapPlanes() = default;
  CapPlanes(std::vector<glm::dvec4> ofRegion, const IndexTransform& transform, const View& view);
};

/// The normal of a cap, in index space: of a face of the field, of a face of the hidden cell that
/// the ray comes from, or of a plane that clips the field. The nearest counts.
/// \return of unit length, facing against the ray; the zero vector at the near plane, and if the
/// point is on none of them
glm::dvec3 CapNormal(
  CapPoint cap, const Field& field, const FieldNormals& normals, const CapPlanes& planes);

}

#endif
