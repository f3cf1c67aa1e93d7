// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsHitPlaces_h
#define TemporalCoherence_KernelsHitPlaces_h

#include "Mesh/Cells/KernelsCellGradients.h"
#include "Scene/HitRays.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Where hits lie in the coordinates of a mesh: low + scale * index.
void FindHitPlaces(const HitRays& rays, const glm::dmat4& indexFromWorld, const glm::dvec3& low,
  double scale, MeshKernels::PointsInCells::Vectors& places);

}

#endif
