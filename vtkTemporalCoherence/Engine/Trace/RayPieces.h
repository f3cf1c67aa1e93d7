// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayPieces_h
#define TemporalCoherence_RayPieces_h

#include "Scene/RayBatch.h"
#include "Trace/RegionClipper.h"

#include <functional>

namespace TemporalCoherence
{

/// Finds one surface along each ray of a batch, behind the one that the ray has in `hits`.
using FindSurfaces = std::function<void(const RayBatch& rays, HitBatch& hits)>;

/// Find one surface along each ray of which the region keeps several pieces: first in the nearest
/// pieces, then, for rays without a hit there, in the next ones.
/// \param hits on entry the last surface of each ray, from which the search goes on, or none.
///             Pieces that end before that surface are skipped. On return the surface found, and
///             the nearest first entry of all pieces searched.
/// \pre clipper.HasPieces()
void FindInPieces(
  const RegionClipper& clipper, const RayBatch& rays, HitBatch& hits, const FindSurfaces& find);

}

#endif
