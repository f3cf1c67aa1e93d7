// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CompositeBeam_h
#define TemporalCoherence_CompositeBeam_h

#include "Acceleration/ActiveCells.h"
#include "Blending/KernelsEmission.h"
#include "Blending/KernelsVolumeSegments.h"
#include "Blending/VolumeCell.h"
#include "Composite/EmissionArcs.h"

#include <cstdint>

namespace TemporalCoherence
{

/// A volume that tiles of rays go through as beams.
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
  std::uint64_t All;     ///< those that the beam is made of
  std::uint64_t Walking; ///< those of them that may see anything
};

/// Add what rays of a tile see, from front to back: all of them pass a cell before the next one is
/// taken, so that what is known of it serves them all. Every kind of vectors gives the same bits.
/// \return false if they are not alike: nothing is added then
bool BlendBeam(const BeamVolume& volume, const RayBatch& rays, const BeamRays& which,
  const EmissionKernels::LitRays& lit, BlendedRays& seen);

}

#endif
