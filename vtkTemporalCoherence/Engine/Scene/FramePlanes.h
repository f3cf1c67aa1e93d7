// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FramePlanes_h
#define TemporalCoherence_FramePlanes_h

#include "Scene/Frame.h"
#include "Scene/RayBatch.h"

#include <cstdint>

namespace TemporalCoherence
{

/// What the rays of some tiles came to.
struct TraceCounts
{
  std::int64_t DefiniteHits = 0;
  std::int64_t DefiniteMisses = 0;
  std::int64_t PossibleHits = 0;
  std::int64_t TracedRays = 0;
  std::int64_t CellsRead = 0;
  std::int64_t QueryTime = 0; ///< nanoseconds spent in asking an image, in tiles that were timed
  std::int64_t ShadeTime = 0; ///< and in shading
  std::int64_t TileTime = 0;  ///< and all told

  TraceCounts& operator+=(const TraceCounts& other)
  {
    this->DefiniteHits += other.DefiniteHits;
    this->DefiniteMisses += other.DefiniteMisses;
    this->PossibleHits += other.PossibleHits;
    this->TracedRays += other.TracedRays;
    this->CellsRead += other.CellsRead;
    this->QueryTime += other.QueryTime;
    this->ShadeTime += other.ShadeTime;
    this->TileTime += other.TileTime;
    return *this;
  }
};

/// Write a tile through which no surface can be seen into the planes of a frame.
/// \param tile number of the tile, `part` its pixels
/// \param isParallel kind of the projection
void StoreMisses(std::int64_t tile, const PixelRect& part, bool isParallel, Frame& frame);

/// Copy a tile from an exact picture that shows the same there. Its answers are known then.
TraceCounts CopyTile(
  std::int64_t tile, const PixelRect& part, const Frame& from, bool isParallel, Frame& frame);

/// Write what a ray of a batch found into the planes of a frame.
void StoreHit(const RayBatch& rays, const HitBatch& hits, std::size_t ray, Answer answer,
  bool isParallel, Frame& frame);

/// Write what all rays of a tile found, likewise. A full batch is a whole tile, row by row.
void StoreHits(const RayBatch& rays, const HitBatch& hits, const RayBatch::Array<Answer>& answers,
  bool isParallel, Frame& frame);

/// Let the rays of a batch walk from where an exact picture of a lower isovalue shows them to come
/// to it from below: before that they do not meet what lies above.
void BeginAtFirstEntries(const Frame& picture, bool isParallel, RayBatch& rays);

/// Disparity at a distance along a ray of a batch; that of a miss if it is infinite.
float DisparityAt(const RayBatch& rays, std::size_t ray, double t, bool isParallel);

}

#endif
