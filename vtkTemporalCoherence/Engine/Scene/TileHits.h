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

  /// Make the first layers the hits.
  void TakeFirstLayers()
  {
    this->HasLayers = true;
    this->Hits.Clear(this->Rays.Count);
    this->Hits.CellsRead = this->Layers.CellsRead;
    for (std::size_t i = 0; i < static_cast<std::size_t>(this->Rays.Count); ++i)
    {
      if (this->Layers.Count[i] > 0)
      {
        const std::size_t first = this->Layers.Place[0][i];
        this->Hits.Depth[i] = this->Layers.Distance[first];
        this->Hits.Surface[i] = this->Layers.Surface[first];
        this->Hits.Kind[i] = this->Layers.Kind[first];
        this->Hits.Cell[i] = this->Layers.Cell[first];
      }
    }
  }
};

}

#endif
