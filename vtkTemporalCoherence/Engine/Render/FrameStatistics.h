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
  std::int64_t FieldSamples = 0;  ///< samples read to find surfaces and to build an isomap
  double Progress = 1.0;          ///< towards the final picture, from 0 to 1
  std::int64_t Layers = 0;        ///< surfaces that were composited, if some are translucent
  std::int64_t MergedLayers = 0;  ///< of these, layers that were merged into one in front
  std::int64_t TilesLookedUp = 0; ///< in existing bands of an isomap
  std::int64_t TilesBuilt = 0;    ///< looked up in bands built for this frame
  std::int64_t TilesTraced = 0;   ///< on the routes of an isomap
  std::int64_t GridRays = 0;      ///< of a frame from fewer rays: those of its grids
  double GridTime = 0.0;          ///< seconds to trace these
  double TilesTime = 0.0;         ///< seconds to make tiles
  double FillTime = 0.0;          ///< seconds to fill the tiles between rays
  double FrameTime = 0.0;         ///< seconds in total
  double TraceTime = 0.0;         ///< of these, structures and rays
  double QueryTime = 0.0;         ///< of these, querying the image cache
  double IsomapBuildTime = 0.0;   ///< of these, building bands of the isomap
  double ShadeTime = 0.0;         ///< of these, normals and colours

  /// Add the counts of tiles that took `seconds`. Threads build, query, trace and shade tile by
  /// tile, so the time is split by the shares measured in some tiles.
  void Add(const TraceCounts& counts, double seconds)
  {
    this->DefiniteHits += counts.DefiniteHits;
    this->DefiniteMisses += counts.DefiniteMisses;
    this->PossibleHits += counts.PossibleHits;
    this->TracedRays += counts.TracedRays;
    this->FieldSamples += 8 * counts.CellsRead;
    this->Layers += counts.Layers;
    this->MergedLayers += counts.MergedLayers;
    const auto shareOf = [](std::int64_t time, std::int64_t total)
    { return total > 0 ? static_cast<double>(time) / static_cast<double>(total) : 0.0; };
    const double build = shareOf(counts.BuildTime, counts.GroupTime) * seconds;
    const double query = shareOf(counts.QueryTime, counts.TileTime) * (seconds - build);
    const double shade = shareOf(counts.ShadeTime, counts.TileTime) * (seconds - build);
    this->IsomapBuildTime += build;
    this->QueryTime += query;
    this->ShadeTime += shade;
    this->TraceTime += seconds - build - query - shade;
    this->TilesTime += seconds;
  }
};

}

#endif
