// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameStatistics_h
#define TemporalCoherence_FrameStatistics_h

#include "Render/ReusePlan.h"
#include "Scene/FramePlanes.h"

#include <cstdint>

namespace TemporalCoherence
{

/// How the last frame was made, and what it cost.
struct FrameStatistics
{
  Route Made = Route::Cold;
  std::int64_t Rays = 0; ///< pixels; the sum of the next three
  std::int64_t DefiniteHits = 0;
  std::int64_t DefiniteMisses = 0;
  std::int64_t PossibleHits = 0;
  std::int64_t TracedRays = 0;
  std::int64_t FieldSamples = 0; ///< samples read to find surfaces and to build an isomap
  double FrameTime = 0.0;        ///< seconds in total
  double TraceTime = 0.0;        ///< of these, structures and rays
  double QueryTime = 0.0;        ///< of these, querying the image cache
  double IsomapBuildTime = 0.0;  ///< of these, building a band of the isomap
  double ShadeTime = 0.0;        ///< of these, normals and colours

  /// Add the counts of tiles that took `seconds`. Threads query, trace and shade tile by tile, so
  /// the time is divided by the shares that were measured in some tiles.
  void Add(const TraceCounts& counts, double seconds)
  {
    this->DefiniteHits += counts.DefiniteHits;
    this->DefiniteMisses += counts.DefiniteMisses;
    this->PossibleHits += counts.PossibleHits;
    this->TracedRays += counts.TracedRays;
    this->FieldSamples += 8 * counts.CellsRead;
    const auto shareOf = [&](std::int64_t time)
    {
      return counts.TileTime > 0 ? static_cast<double>(time) / static_cast<double>(counts.TileTime)
                                 : 0.0;
    };
    const double query = shareOf(counts.QueryTime), shade = shareOf(counts.ShadeTime);
    this->QueryTime += query * seconds;
    this->ShadeTime += shade * seconds;
    this->TraceTime += (1.0 - query - shade) * seconds;
  }
};

}

#endif
