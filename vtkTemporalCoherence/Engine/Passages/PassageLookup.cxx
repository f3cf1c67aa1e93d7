// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Passages/PassageLookup.h"

#include "Passages/PassageSearch.h"
#include "Trace/RayPieces.h"

namespace TemporalCoherence
{

PassageLookup::PassageLookup(const FrameKey& key, const IsomapLookup& bands,
  const glm::dvec2& finiteRange, const LeapedSpace& space)
  : Key(key)
  , Bands(bands)
  , Bounds(space.Active ? space.Bounds : nullptr)
  , Rays(key.View, key.Transform, key.Samples.Dimensions, key.Region)
  , Tracer(SurfaceTracer::Make({ key.Samples, key.Isosurfaces, finiteRange, space.Active }))
  , Alphas(AlphasOf(key.Isosurfaces))
{
}

TraceCounts PassageLookup::LookUpTile(std::int64_t tile, const PixelRect& part,
  const std::vector<IsomapLookup::IsovalueKeys>& keys, Frame& frame, TileHits& found) const
{
  if (this->Bands.IsMiss(tile, keys))
  {
    StoreMisses(tile, part, this->Key.View.Parallel, frame);
    TraceCounts counts;
    counts.DefiniteMisses = static_cast<std::int64_t>(part.Size.x) * part.Size.y;
    return counts;
  }
  frame.ClearTiles[static_cast<std::size_t>(tile)] = 0;
  RayBatch& rays = found.Rays;
  LayerBatch& layers = found.Layers;
  this->Rays.SetUp(part.First, part.Size, rays, &found.World);
  layers.Begin(static_cast<std::size_t>(rays.Count), this->Alphas);
  layers.Limit = LayerBatch::MostLayers; // more are found as quickly as one
  const std::uint64_t rest = this->SearchPieces(tile, keys, rays, layers);
  layers.Open &= rest;
  const auto traced = static_cast<std::int64_t>(hwy::PopCount(layers.Open));
  if (this->Bounds)
  {
    this->Bounds->Narrow(tile, rays);
  }
  if (traced > 0)
  {
    rays.MayBeCapped = true;
    FindLayersWithin(this->Rays.Clipper, *this->Tracer, rays, layers);
  }
  found.TakeFirstLayers();
  TraceCounts counts = this->Bands.StoreFound(0, found, frame);
  counts.TracedRays = traced;
  return counts;
}

/// \return one bit for each ray that must be traced behind its last layer
std::uint64_t PassageLookup::SearchPieces(std::int64_t tile,
  const std::vector<IsomapLookup::IsovalueKeys>& keys, const RayBatch& rays,
  LayerBatch& layers) const
{
  if (!this->Rays.Clipper.HasPieces())
  {
    return this->Search(tile, 0, keys, rays, layers);
  }
  const RayPieces pieces(this->Rays.Clipper, rays);
  std::uint64_t rest = 0, open = layers.Open;
  for (std::size_t piece = 0; piece < RegionClipper::MostPieces && open != 0; ++piece)
  {
    RayBatch parts = rays;
    layers.Open = pieces.Clip(piece, parts) & open;
    const std::uint64_t which = layers.Open;
    rest |= this->Search(tile, piece, keys, parts, layers);
    // Rays that are full or opaque need no other piece.
    open &= ~rest & ~(which & ~layers.Open);
  }
  layers.Open = rest;
  return rest;
}

/// The same for a piece of each open ray.
std::uint64_t PassageLookup::Search(std::int64_t tile, std::size_t piece,
  const std::vector<IsomapLookup::IsovalueKeys>& keys, const RayBatch& rays,
  LayerBatch& layers) const
{
  PassageSearch search(*this->Tracer, rays, keys.size(), layers);
  for (std::size_t surface = 0; surface < keys.size(); ++surface)
  {
    if (const TileKnots* const pieces = this->Bands.KnotsOf(keys[surface], tile))
    {
      search.Add(surface, pieces[piece], keys[surface].InPassages);
    }
  }
  return search.Search();
}

}
