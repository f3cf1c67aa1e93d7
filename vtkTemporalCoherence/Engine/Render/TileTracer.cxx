// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/TileTracer.h"

#include "Kinds/FieldKind.h"
#include "Lattice/RayPieces.h"
#include "Render/CapTiles.h"
#include "Scene/FramePlanes.h"
#include "Scene/Timers.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// No hint.
const RayHint NoHint;

void Count(Answer answer, TraceCounts& counts)
{
  counts.DefiniteHits += answer == Answer::DefiniteHit;
  counts.DefiniteMisses += answer == Answer::DefiniteMiss;
  counts.PossibleHits += answer == Answer::PossibleHit;
}

}

TileTracer::TileTracer(const TileScene& scene)
  : Scene(scene)
  , Rays(scene.Key.View, scene.Key.Transform, scene.Key.Samples.Dimensions, scene.Key.Region)
  , HasSurfaces(scene.Key.Samples.HasCells() && !scene.Key.Isosurfaces().Isovalues.empty())
  , IsSolid(scene.Key.Isosurfaces().Mode == SurfaceMode::Threshold)
  , Tracer(MakeSurfaceTracer({ scene.Key.Samples, scene.Key.Isosurfaces(), scene.FiniteRange,
      scene.Active, scene.Hint != nullptr }))
  , Alphas(scene.Hint ? std::vector<float>() : AlphasOf(scene.Key.Isosurfaces()))
{
  if (this->HasSurfaces && this->IsSolid && scene.Active && scene.Ranges)
  {
    this->Capped = FindCapTiles(scene.Key, this->Rays, *scene.Ranges);
  }
}

/// True if a ray of a tile may begin in a solid.
bool TileTracer::MayBeCapped(std::int64_t tile) const
{
  return this->IsSolid &&
    (this->Capped.empty() || this->Capped[static_cast<std::size_t>(tile)] != 0);
}

bool TileTracer::CanSkip(std::int64_t tile) const
{
  // A solid may be capped where there is no active cell.
  return !this->HasSurfaces ||
    (this->Scene.Active && this->Scene.Bounds->At(tile).IsEmpty() && !this->MayBeCapped(tile));
}

bool TileTracer::SetUp(std::int64_t tile, const PixelRect& part, TileHits& found) const
{
  if (this->CanSkip(tile))
  {
    return false;
  }
  this->Rays.SetUp(part.First, part.Size, found.Rays, &found.World);
  found.Rays.MayBeCapped = this->MayBeCapped(tile);
  if (this->Scene.Active)
  {
    this->Scene.Bounds->Narrow(tile, found.Rays);
  }
  return true;
}

TraceCounts TileTracer::Trace(
  std::int64_t tile, const PixelRect& part, Frame& frame, TileHits& found) const
{
  TraceCounts counts;
  KnownRays known;
  const RayHint& hint = this->Scene.Hint ? *this->Scene.Hint : NoHint;
  bool isMiss = !this->SetUp(tile, part, found);
  if (!isMiss && this->Scene.Hint)
  {
    const TileTimer timer(tile, counts.QueryTime);
    isMiss = !hint.Narrow(found.Rays, known) && !this->IsSolid;
  }
  if (isMiss)
  {
    StoreMisses(tile, part, this->Scene.Key.View.Parallel, frame);
    counts.DefiniteMisses = static_cast<std::int64_t>(part.Size.x) * part.Size.y;
    return counts;
  }
  frame.ClearTiles[static_cast<std::size_t>(tile)] = 0;
  this->TraceRays(hint, known, found, frame, counts);
  return counts;
}

TraceCounts TileTracer::TraceSome(std::int64_t tile, const PixelRect& part, std::uint64_t which,
  Frame& frame, const Frame* before) const
{
  TraceCounts counts;
  RayBatch all;
  TileHits found;
  RayBatch& rays = found.Rays;
  this->Rays.SetUp(part.First, part.Size, all);
  // Where rays have several pieces, each may begin in a solid.
  const bool startsThere = before && !this->Rays.Clipper.HasPieces();
  all.MayBeCapped = !startsThere && this->MayBeCapped(tile);
  if (this->Scene.Active)
  {
    this->Scene.Bounds->Narrow(tile, all);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(all.Count); ++i)
  {
    if (which >> i & 1u)
    {
      if (startsThere)
      {
        const double met = before->Depth[static_cast<std::size_t>(all.Pixel[i])];
        // Rounding may have moved the hit to the end of its cell.
        constexpr double slack = 1e-9;
        all.WalkBegin[i] = std::max(all.WalkBegin[i], met - slack * std::abs(met));
      }
      AppendRay(all, i, rays);
    }
  }
  this->TraceRays(NoHint, {}, found, frame, counts);
  return counts;
}

bool TileTracer::TraceAt(std::int64_t tile, const LooseRays& loose, TileHits& found) const
{
  if (this->CanSkip(tile))
  {
    return false;
  }
  RayBatch& rays = found.Rays;
  loose.SetUp(this->Rays, rays, &found.World);
  rays.MayBeCapped = this->MayBeCapped(tile);
  if (this->Scene.Active)
  {
    this->Scene.Bounds->Narrow(tile, rays);
  }
  if (this->Scene.Key.Isosurfaces().IsTranslucent())
  {
    found.Hits.CellsRead = 0; // the shader finds them
  }
  else
  {
    this->Find(rays, found.Hits);
  }
  return true;
}

/// Find the first surface along each ray within the region.
void TileTracer::Find(const RayBatch& rays, HitBatch& hits) const
{
  if (!this->Rays.Clipper.HasPieces())
  {
    this->Tracer->Trace(rays, hits);
    return;
  }
  hits.Clear(rays.Count);
  FindInPieces(this->Rays.Clipper, rays, hits,
    [this](const RayBatch& part, HitBatch& found) { this->Tracer->Trace(part, found); });
}

/// Find the first layers of all rays, as deep as the opacities of the isovalues let light pass. The
/// nearest layers are the hits.
void TileTracer::FindFirstLayers(TileHits& found) const
{
  LayerBatch& layers = found.Layers;
  layers.Begin(static_cast<std::size_t>(found.Rays.Count), this->Alphas);
  FindLayersWithin(this->Rays.Clipper, *this->Tracer, found.Rays, layers);
  found.HasLayers = true;
  found.Hits.Clear(found.Rays.Count);
  found.Hits.CellsRead = layers.CellsRead;
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.Rays.Count); ++i)
  {
    if (layers.Count[i] > 0)
    {
      const std::size_t first = layers.Place[0][i];
      found.Hits.Depth[i] = layers.Distance[first];
      found.Hits.Surface[i] = layers.Surface[first];
      found.Hits.Kind[i] = layers.Kind[first];
      found.Hits.Cell[i] = layers.Cell[first];
    }
  }
}

/// Trace the rays of a tile. Trace rays with a wrong hint a second time.
void TileTracer::TraceRays(const RayHint& hint, const KnownRays& known, TileHits& found,
  Frame& frame, TraceCounts& counts) const
{
  RayBatch& rays = found.Rays;
  HitBatch& hits = found.Hits;
  if (!this->Alphas.empty() && this->Tracer->FindsLayersTogether(rays))
  {
    this->FindFirstLayers(found);
  }
  else
  {
    this->Find(rays, hits);
  }
  counts.CellsRead += hits.CellsRead;
  if (!this->Scene.Hint)
  {
    this->Store(rays, hits, frame, counts);
    found.AreAll = true;
    return;
  }
  RayBatch again;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    if (hint.TakeOver(known, rays, i, frame))
    {
      ++counts.DefiniteHits;
    }
    else if (hint.Correct(known, hits, i, rays))
    {
      AppendRay(rays, i, again);
    }
    else
    {
      const RayHint::Told told = hint.TellOf(known, rays, hits, i);
      counts.TracedRays += told.WasTraced;
      Count(told.Known, counts);
      StoreHit(rays, hits, i, told.Known, this->Scene.Key.View.Parallel, frame);
    }
  }
  this->TraceAgain(again, frame, counts);
}

/// Write the hits of rays without a hint.
void TileTracer::Store(
  const RayBatch& rays, const HitBatch& hits, Frame& frame, TraceCounts& counts) const
{
  RayBatch::Array<Answer> answers;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const RayHint::Told told = NoHint.TellOf({}, rays, hits, i);
    counts.TracedRays += told.WasTraced;
    Count(told.Known, counts);
    answers[i] = told.Known;
  }
  StoreHits(rays, hits, answers, this->Scene.Key.View.Parallel, frame);
}

/// Trace rays with a wrong hint again.
void TileTracer::TraceAgain(const RayBatch& rays, Frame& frame, TraceCounts& counts) const
{
  if (rays.Count == 0)
  {
    return;
  }
  HitBatch hits;
  this->Find(rays, hits);
  counts.CellsRead += hits.CellsRead;
  counts.TracedRays += rays.Count;
  counts.PossibleHits += rays.Count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    StoreHit(rays, hits, i, Answer::PossibleHit, this->Scene.Key.View.Parallel, frame);
  }
}

}
