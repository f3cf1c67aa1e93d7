// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsMeshRays_h
#define TemporalCoherence_KernelsMeshRays_h

#include "Mesh/Cells/CellRays.h"
#include "Scene/RayBatch.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Put the rays of a batch into the coordinates of a mesh: low + scale * index. They keep Begin and
/// End, and are prepared for kernels.
void PutIntoMesh(
  const RayBatch& rays, const glm::dvec3& low, double scale, MeshKernels::MeshRays& inMesh);

}

#endif
