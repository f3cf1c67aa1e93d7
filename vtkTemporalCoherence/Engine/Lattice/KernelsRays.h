// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsRays_h
#define TemporalCoherence_KernelsRays_h

#include "Lattice/RaySource.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// RaySource::SetUp in the widest vectors of the machine.
void SetUpRays(const RaySource& source, const glm::ivec2& first, const glm::ivec2& size,
  RayBatch& rays, WorldDirections* world = nullptr);

/// RaySource::SetUpAt in the widest vectors of the machine.
void SetUpRaysAt(
  const RaySource& source, const RayPlaces& at, RayBatch& rays, WorldDirections* world);

/// Selects rays with a walk and no hit yet, one bit each.
std::uint64_t WalksWithoutHit(const RayBatch& rays, const HitBatch& hits);

/// A cell for each ray.
using CellsOfRays = std::array<RayBatch::Array<std::int32_t>, 3>;

/// Find the cells in which rays begin, as BatchRay::CellAt does.
/// \param count of cells along each axis
void FindFirstCells(const RayBatch& rays, const glm::ivec3& count, CellsOfRays& cells);

}

#endif
