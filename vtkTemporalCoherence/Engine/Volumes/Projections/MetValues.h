// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MetValues_h
#define TemporalCoherence_MetValues_h

#include "Scene/Blending.h"
#include "Scene/Frame.h"
#include "Volumes/Medium/BlendTracer.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

// Frames store the extremes or the integrals of a projection. Colours are made of them.

/// The stored numbers of each ray; 0 if the mode has none.
std::size_t NumbersMet(const Blending& volume);

/// True if two projections have the same extremes or integrals, whatever their colours.
bool MeetSameValues(const Blending& a, const Blending& b);

/// The range in which a picture knows all extremes.
glm::dvec2 ExtremesMet(const Blending& volume);

/// True if a range of known extremes contains all visible extremes of a volume.
bool KnowsAllExtremes(const glm::dvec2& within, const Blending& volume);

/// Store the extremes or integrals of a tile's rays in a frame with room for them. Extremes outside
/// of the frame's range become NaN.
void KeepMet(const Blending& volume, std::int64_t tile, const BlendedRays& seen, Frame& frame);

/// Load the extremes or integrals of a tile's rays from a frame that stores them.
/// \return one bit for each ray whose extreme is within the range of the frame, or whose integral
///         is known
std::uint64_t TakeMet(
  const Blending& volume, std::int64_t tile, const Frame& frame, BlendedRays& seen);

}

#endif
