// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/BandBuilder.h"

#include "Isomap/TileGroups.h"
#include "Lattice/RayPieces.h"

#include <algorithm>
#include <utility>

namespace TemporalCoherence
{

BandBuilder::BandBuilder(const BandSource& source, const Isomap& map, const ValueBand& band,
  const TileBounds* bounds, std::size_t most)
  : Key(source.Key)
  , Values(band)
  , Pieces(map.Pieces())
  , Rays(Key.View, Key.Transform, Key.Samples.Dimensions, Key.Region)
  , Bounds(bounds)
{
  const FrameKey& key = source.Key;
  const SurfaceMode mode = key.Isosurfaces().Mode;
  this->Active.Build(key.Samples, source.Pyramid, band, mode);
  BandScene scene{ key.Samples, source.Pyramid.FiniteRange(), &source.Pyramid, &this->Active, band,
    mode, map.Form(), key.Transform };
  scene.MemoryLimit = most;
  this->Tracer = source.MakeTracer(scene);
}

void BandBuilder::FindBounds(const BandSource& source, const ValueBand& band, TileBounds& bounds)
{
  const FrameKey& key = source.Key;
  ActiveCells active;
  active.Build(key.Samples, source.Pyramid, band, key.Isosurfaces().Mode);
  bounds.Build(key.View, key.Transform, active, *key.Samples.Shape);
  bounds.ReleaseScratch();
}

GroupBand BandBuilder::Build(std::size_t group, std::int64_t& cellsRead) const
{
  const TileRange range = TilesOfGroup(this->Key.View.Size, group);
  GroupBand band;
  band.Values = this->Values;
  band.Memory = sizeof(GroupBand);
  std::vector<TileKnots> tiles;
  for (std::int64_t tile = range.First; tile < range.End; ++tile)
  {
    if (this->CanSkip(tile))
    {
      continue;
    }
    tiles.resize(static_cast<std::size_t>(range.End - range.First) * this->Pieces);
    this->Trace(
      tile, &tiles[static_cast<std::size_t>(tile - range.First) * this->Pieces], cellsRead);
  }
  if (std::all_of(
        tiles.begin(), tiles.end(), [](const TileKnots& knots) { return knots.IsEmpty(); }))
  {
    return band;
  }
  band.Memory += tiles.size() * sizeof(TileKnots);
  for (const TileKnots& knots : tiles)
  {
    band.Memory += knots.MemoryInBytes();
    band.NumberOfKnots += knots.NumberOfKnots();
  }
  band.Tiles = std::move(tiles);
  return band;
}

/// True if a tile's rays meet no active cell. Never for solids, which may be capped outside active
/// cells.
bool BandBuilder::CanSkip(std::int64_t tile) const
{
  return this->Bounds && this->Key.Isosurfaces().Mode == SurfaceMode::Crossing &&
    this->Bounds->At(tile).IsEmpty();
}

void BandBuilder::Trace(std::int64_t tile, TileKnots* knots, std::int64_t& cellsRead) const
{
  const PixelRect part = PixelsOfTile(this->Key.View.Size, tile);
  RayBatch rays;
  this->Rays.SetUp(part.First, part.Size, rays);
  if (this->Bounds)
  {
    this->Bounds->Narrow(tile, rays);
  }
  if (!this->Rays.Clipper.HasPieces())
  {
    cellsRead += this->Tracer->Trace(rays, *knots);
    return;
  }
  const RayPieces pieces(this->Rays.Clipper, rays);
  RayBatch clipped = rays;
  for (std::size_t piece = 0; pieces.Clip(piece, clipped) != 0; ++piece)
  {
    cellsRead += this->Tracer->Trace(clipped, knots[piece]);
    clipped = rays;
  }
}

}
