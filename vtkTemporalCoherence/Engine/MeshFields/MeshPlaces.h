// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshPlaces_h
#define TemporalCoherence_MeshPlaces_h

#include "Scene/Frame.h"
#include "Trees/MeshTree.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// The cell of the lowest number that holds a point in the coordinates of the mesh; NoCell if there
/// is none.
CellNumber FindCellAt(const MeshTree& tree, const glm::dvec3& point);

/// The normal of the face of the mesh nearest to a point, as FieldKind::FaceNormal.
/// \param point, direction in index space
glm::dvec3 MeshFaceNormal(
  const MeshTree& tree, const glm::dvec3& point, const glm::dvec3& direction, double& nearest);

}

#endif
