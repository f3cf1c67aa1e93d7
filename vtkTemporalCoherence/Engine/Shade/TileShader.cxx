// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/TileShader.h"

#include "Scene/Timers.h"
#include "Shade/HitValues.h"

#include <algorithm>
#include <array>

namespace TemporalCoherence
{

TileShader::TileShader(const ShadeScene& scene, HitSet normalsOf, HitSet colorsOf)
  : Key(scene.Key)
  , Source(NormalSourceOf(scene.Key, scene.Normals, scene.FiniteRange))
  , NormalsOf(normalsOf)
  , ColorsOf(colorsOf)
  , Light(scene.Light)
  , Values(scene.Values)
{
  if (scene.Tracer)
  {
    this->Compositor = std::make_unique<TileCompositor>(
      scene.Key, this->Source, scene.Tracer, scene.Bounds, scene.Light);
  }
}

void TileShader::Shade(std::int64_t tile, const PixelRect& part, TileHits* found, Frame& frame,
  TraceCounts& counts) const
{
  if (this->Compositor)
  {
    const TileTimer timer(tile, counts.ShadeTime);
    if (this->NormalsOf == HitSet::None)
    {
      this->Compositor->CompositeAgain(tile, part, frame, counts);
    }
    else
    {
      this->Compositor->Composite(tile, part, found, frame, counts);
    }
    return;
  }
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return;
  }
  const TileTimer timer(tile, counts.ShadeTime);
  HitList hits;
  if (this->NormalsOf != HitSet::None)
  {
    // Parallel rays begin at points of their own, which the tile does not keep.
    const bool areAtHand = found && found->AreAll && found->Rays.Count == RayBatch::Capacity &&
      this->NormalsOf == HitSet::All && !this->Key.View.Parallel;
    if (areAtHand)
    {
      TakeHits(this->Key.View, *found, hits);
    }
    else
    {
      GatherHits(this->Key.View, part, this->NormalsOf == HitSet::All, frame, hits);
    }
    ComputeNormals(this->Source, hits);
    StoreNormals(hits, frame);
  }
  if (this->ColorsOf != this->NormalsOf)
  {
    GatherHits(this->Key.View, part, this->ColorsOf == HitSet::All, frame, hits);
    LoadNormals(frame, hits);
  }
  if (this->Values)
  {
    this->Values->Find(this->Key, tile, hits);
  }
  else
  {
    FindHitValues(this->Key, hits);
  }
  ArrivingLight arriving;
  if (this->Light && hits.Rays.Count > 0)
  {
    counts.CellsRead += this->Light->Find(tile, hits, true, arriving);
  }
  ShadeHits(this->Key.Appearance, hits, this->Light ? &arriving : nullptr, frame);
  ClearMisses(hits, frame);
}

void TileShader::ShadeAt(
  std::int64_t tile, const RayPlaces& at, TileHits& found, Frame& rays, TraceCounts& counts) const
{
  if (this->Compositor)
  {
    this->Compositor->CompositeAt(tile, at, found, rays, counts);
    return;
  }
  std::fill(rays.Colors.begin(), rays.Colors.end(), std::array<std::uint8_t, 4>{});
  HitList hits;
  TakeHitsAt(this->Key.View, at, found, hits);
  ComputeNormals(this->Source, hits);
  FindHitValues(this->Key, hits);
  ArrivingLight arriving;
  if (this->Light && hits.Rays.Count > 0)
  {
    counts.CellsRead += this->Light->Find(tile, hits, false, arriving);
  }
  ShadeHits(this->Key.Appearance, hits, this->Light ? &arriving : nullptr, rays);
}

void TileShader::ShadeKnown(std::int64_t tile, const PixelRect& part, const Frame& last,
  Frame& frame, TraceCounts& counts) const
{
  const auto place = static_cast<std::size_t>(tile);
  if (last.ClearTiles[place])
  {
    StoreClearTile(tile, part, this->Key.View.Parallel, frame);
    return;
  }
  frame.ClearTiles[place] = 0;
  CopyRays(part, last, frame);
  if (this->Compositor)
  {
    const TileTimer timer(tile, counts.ShadeTime);
    this->Compositor->CompositeKnown(tile, part, KnownLayers(tile, part, last), frame, counts);
    return;
  }
  StoreFirstLayers(KnownLayers(tile, part, last), tile, part, frame);
  this->Shade(tile, part, nullptr, frame, counts);
}

}
