// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellFaces_h
#define TemporalCoherence_CellFaces_h

#include "Mesh/MeshCell.h"

#include <glm/glm.hpp>

#include <array>

namespace TemporalCoherence
{

/// The weights of a cell's points at a place in it, in the coordinates of MeshKernels::FindPoint.
std::array<double, 8> WeightsAt(const MeshCell& cell, const glm::dvec3& at);

/// The face of a cell that is nearest to a place in it.
struct NearestFace
{
  double Distance;   ///< in the coordinates of the mesh; infinite if the cell is flat there
  glm::dvec3 Normal; ///< out of the cell, of unit length
};
NearestFace FindNearestFace(const MeshCell& cell, const glm::dvec3& at);

}

#endif
