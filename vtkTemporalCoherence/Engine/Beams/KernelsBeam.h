// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsBeam_h
#define TemporalCoherence_KernelsBeam_h

#include "Beams/TileBeam.h"
#include "Scene/GridCoordinates.h"

#include <vector>

namespace TemporalCoherence
{

/// Make a beam of some rays of a tile, one bit each.
/// \return false if they are not alike enough, or too far away
bool SetUpBeam(const RayBatch& rays, std::uint64_t which, const glm::ivec3& cells, TileBeam& beam);

/// What a search goes through.
struct BeamTask
{
  /// Isovalues, in units of a scene's corners and as differences from the same isovalue.
  const std::vector<float>& Isovalues;
  const ActiveCells& Active;
  bool IsSolid; ///< a ray that is inside meets the surface where it enters a cell
  const GridCoordinates* Grid = nullptr; ///< of samples; null: they lie at integers
};

/// Take a beam through the active cells, from front to back, up to where all of its rays have met a
/// surface for sure. What is left open is decided by the scene, when there is much of it, and at
/// the end.
///
/// In a cell that is neither noted for a ray nor told to the scene, the ray meets no surface, or
/// not its first one.
void SearchBeam(const BeamTask& task, BeamScene& scene, TileBeam& beam);

}

#endif
