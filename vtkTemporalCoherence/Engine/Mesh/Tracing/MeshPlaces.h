// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshPlaces_h
#define TemporalCoherence_MeshPlaces_h

#include "Mesh/Tree/MeshTree.h"
#include "Scene/CapPoint.h"
#include "Scene/Frame.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// The cell of the lowest number that holds a point in the coordinates of the mesh; NoCell if there
/// is none.
CellNumber FindCellAt(const MeshTree& tree, const glm::dvec3& point);

/// The normal of the face through which a ray enters the cell that it hits, as
/// FieldNormals::FaceNormal.
glm::dvec3 MeshFaceNormal(const MeshTree& tree, const CapPoint& cap, double& nearest);

}

#endif
