// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MetValues_h
#define TemporalCoherence_MetValues_h

#include "Blending/BlendTracer.h"
#include "Scene/Blending.h"
#include "Scene/Frame.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

// What a frame keeps of a projection: extremes, or integrals. Colours are made of them.

/// How many numbers a frame keeps of each ray; 0 if the mode has none.
std::size_t NumbersMet(const Blending& volume);

/// True if the rays of two projections meet the same values, whatever these look like.
bool MeetSameValues(const Blending& a, const Blending& b);

/// Extremes of which a picture knows all that lie within.
glm::dvec2 ExtremesMet(const Blending& volume);

/// True if a picture that knows the extremes within some range knows all that can be seen now.
bool KnowsAllExtremes(const glm::dvec2& within, const Blending& volume);

/// Keep what the rays of a tile have met, in a frame with room for it. Extremes that are not within
/// its range are forgotten.
void KeepMet(const Blending& volume, std::int64_t tile, const BlendedRays& seen, Frame& frame);

/// Take what the rays of a tile have met from a frame that keeps it.
/// \return one bit for each ray whose extreme is within the range of the frame, or whose integral
///         is known
std::uint64_t TakeMet(
  const Blending& volume, std::int64_t tile, const Frame& frame, BlendedRays& seen);

}

#endif
