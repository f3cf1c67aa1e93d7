// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileHits_h
#define TemporalCoherence_TileHits_h

#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"

#include <array>

namespace TemporalCoherence
{

/// Unit directions of rays in the world, by axis.
using WorldDirections = std::array<RayBatch::Array<double>, 3>;

/// The rays of a tile with their hits. One stage of a frame hands them to the next within the
/// caches.
struct TileHits
{
  RayBatch Rays;
  WorldDirections World;
  HitBatch Hits;
  bool AreAll = false; ///< the planes of the frame hold these hits, one for each ray
  /// The first layers of each ray, if surfaces are translucent and the search for hits found
  /// layers.
  LayerBatch Layers;
  bool HasLayers = false;
};

}

#endif
