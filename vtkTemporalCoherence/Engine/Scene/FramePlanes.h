// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FramePlanes_h
#define TemporalCoherence_FramePlanes_h

#include "Scene/Frame.h"
#include "Scene/RayBatch.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Statistics of the rays of some tiles.
struct TraceCounts
{
  std::int64_t DefiniteHits = 0;
  std::int64_t DefiniteMisses = 0;
  std::int64_t PossibleHits = 0;
  std::int64_t TracedRays = 0;
  std::int64_t CellsRead = 0;
  std::int64_t Layers = 0;       ///< surfaces that were composited, if some are translucent
  std::int64_t MergedLayers = 0; ///< of these, layers that were merged into one in front
  std::int64_t QueryTime = 0;    ///< nanoseconds to query a cached image, in tiles that were timed
  std::int64_t ShadeTime = 0;    ///< nanoseconds of shading, in tiles that were timed
  std::int64_t TileTime = 0;     ///< nanoseconds in all, in tiles that were timed
  std::int64_t BuildTime = 0; ///< nanoseconds to build bands of an isomap, in all groups of tiles
  std::int64_t GroupTime = 0; ///< nanoseconds in all groups of tiles

  TraceCounts& operator+=(const TraceCounts& other)
  {
    this->DefiniteHits += other.DefiniteHits;
    this->DefiniteMisses += other.DefiniteMisses;
    this->PossibleHits += other.PossibleHits;
    this->TracedRays += other.TracedRays;
    this->CellsRead += other.CellsRead;
    this->Layers += other.Layers;
    this->MergedLayers += other.MergedLayers;
    this->QueryTime += other.QueryTime;
    this->ShadeTime += other.ShadeTime;
    this->TileTime += other.TileTime;
    this->BuildTime += other.BuildTime;
    this->GroupTime += other.GroupTime;
    return *this;
  }
};

/// Write a tile in which every ray misses into the planes of a frame.
/// \param tile number of the tile, `part` its pixels
/// \param isParallel kind of the projection
void StoreMisses(std::int64_t tile, const PixelRect& part, bool isParallel, Frame& frame);

/// Copy a tile from an exact picture that is equal there. Its answers become definite.
TraceCounts CopyTile(
  std::int64_t tile, const PixelRect& part, const Frame& from, bool isParallel, Frame& frame);

/// Copy all that does not depend on opacities in a tile: kinds of hits, answers, and the planes
/// that views made from the frame need.
void CopyRays(const PixelRect& part, const Frame& from, Frame& frame);

/// Write the hit of one ray into the planes of a frame.
void StoreHit(const RayBatch& rays, const HitBatch& hits, std::size_t ray, Answer answer,
  bool isParallel, Frame& frame);

/// Write the hits of all rays of a tile. A full batch is a whole tile, row by row.
void StoreHits(const RayBatch& rays, const HitBatch& hits, const RayBatch::Array<Answer>& answers,
  bool isParallel, Frame& frame);

/// Disparity at a distance along a ray of a batch; the disparity of a miss if the distance is
/// infinite.
float DisparityAt(const RayBatch& rays, std::size_t ray, double t, bool isParallel);

}

#endif
