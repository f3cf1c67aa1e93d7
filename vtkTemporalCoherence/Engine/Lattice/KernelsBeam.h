// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsBeam_h
#define TemporalCoherence_KernelsBeam_h

#include "Lattice/TileBeam.h"
#include "Scene/GridCoordinates.h"

#include <vector>

namespace TemporalCoherence
{

/// Make a beam of some rays of a tile, one bit each.
/// \return false if they are not alike enough, or too far away
bool SetUpBeam(const RayBatch& rays, std::uint64_t which, const glm::ivec3& cells, TileBeam& beam);

/// The input of SearchBeam.
struct BeamTask
{
  /// Isovalues as scaled differences from the base isovalue (BeamLevels).
  const std::vector<float>& Isovalues;
  const ActiveCells& Active;
  bool IsSolid; ///< a ray that is inside meets the surface where it enters a cell
  const GridCoordinates* Grid = nullptr; ///< of samples; null: they lie at integers
};

/// Take a beam through the active cells, from front to back, until every ray ends or has a certain
/// hit. The scene decides cells that single precision leaves open, whenever the list is long and at
/// the end.
///
/// A cell that is neither a ray's TileBeam::Cell nor in its OpenCells does not hold the ray's first
/// surface.
void SearchBeam(const BeamTask& task, BeamScene& scene, TileBeam& beam);

}

#endif
