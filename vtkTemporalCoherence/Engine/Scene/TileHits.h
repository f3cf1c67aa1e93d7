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

/// The rays of a tile and what they hit: what a stage leaves to the next one while it is in the
/// caches.
struct TileHits
{
  RayBatch Rays;
  WorldDirections World;
  HitBatch Hits;
  bool AreAll = false; ///< the planes of the frame hold these hits, one for each ray
  /// If surfaces are translucent and layers were found with the hits: the first ones of each ray.
  LayerBatch Layers;
  bool HasLayers = false;
};

}

#endif
