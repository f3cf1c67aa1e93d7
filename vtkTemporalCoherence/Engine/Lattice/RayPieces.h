// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayPieces_h
#define TemporalCoherence_RayPieces_h

#include "Lattice/RegionClipper.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/RayBatch.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace TemporalCoherence
{

/// The pieces that a region leaves of the rays of a tile.
class RayPieces
{
public:
  RayPieces(const RegionClipper& clipper, const RayBatch& rays);

  std::size_t CountOf(std::size_t ray) const { return this->Pieces[ray].Count; }
  const glm::dvec2& EndsOf(std::size_t ray, std::size_t piece) const
  {
    return this->Pieces[ray].Ends[piece];
  }

  /// Clip rays to their piece number `piece`. A ray that has no such piece becomes empty.
  /// \return one bit for each ray that has one
  std::uint64_t Clip(std::size_t piece, RayBatch& rays) const;

private:
  RayBatch::Array<RegionClipper::Pieces> Pieces;
};

/// Finds the next surface along each ray of a batch, behind the ray's surface in `hits`.
using FindSurfaces = std::function<void(const RayBatch& rays, HitBatch& hits)>;

/// Find one surface along each ray that the region splits into pieces: first in the nearest pieces,
/// then, for rays without a hit there, in the next pieces.
/// \param hits on entry the last surface of each ray, from which the search goes on, or none.
///             Pieces that end before that surface are skipped. On return the surface found.
/// \pre clipper.HasPieces()
void FindInPieces(
  const RegionClipper& clipper, const RayBatch& rays, HitBatch& hits, const FindSurfaces& find);

/// Append the next surfaces along the open rays of a batch within a region: SurfaceTracer's
/// FindLayers. If the region splits rays, it searches the nearest pieces first, then, for rays
/// still open, the next pieces.
void FindLayersWithin(const RegionClipper& clipper, const SurfaceTracer& tracer,
  const RayBatch& rays, LayerBatch& layers);

}

#endif
