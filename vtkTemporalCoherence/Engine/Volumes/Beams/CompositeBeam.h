// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CompositeBeam_h
#define TemporalCoherence_CompositeBeam_h

#include "Acceleration/ActiveCells.h"
#include "Volumes/Beams/EmissionArcs.h"
#include "Volumes/Medium/KernelsEmission.h"
#include "Volumes/Medium/KernelsVolumeSegments.h"
#include "Volumes/Medium/VolumeCell.h"

#include <cstdint>

namespace TemporalCoherence
{

/// The volume that a beam, the rays of a tile, traverses.
struct BeamVolume
{
  const EmissionKernels::EmittingVolume& Emitting;
  const EmissionArcs& Arcs;
  const ActiveCells& Active;
  const VolumeCells& Cells;
  const SegmentsKernels::SeenBins& Seen;
  glm::ivec3 NumberOfCells; ///< along each axis
};

/// Rays of a tile, one bit each.
struct BeamRays
{
  std::uint64_t All;     ///< rays that span the beam
  std::uint64_t Walking; ///< rays that may see something
};

/// Composite the light that the rays of a tile see, from front to back. The beam visits each cell
/// once, so that all rays share the cell's data. Every kind of vectors gives the same bits.
/// \return false, with nothing added, if the rays differ too much for a beam
bool BlendBeam(const BeamVolume& volume, const RayBatch& rays, const BeamRays& which,
  const EmissionKernels::LitRays& lit, BlendedRays& seen);

}

#endif
