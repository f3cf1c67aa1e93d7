// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/SurfaceTracer.h"

namespace TemporalCoherence
{
namespace
{

/// The open rays of a batch, and the last surface of each.
struct RestOfRays
{
  RestOfRays(const RayBatch& rays, const LayerBatch& layers)
  {
    ForEachRay(layers.Open,
      [&](std::size_t ray)
      {
        const auto at = static_cast<std::size_t>(this->Rays.Count);
        this->From[at] = ray;
        this->Hits.Depth[at] = layers.LastDistance[ray];
        this->Hits.Surface[at] = layers.LastSurface[ray];
        this->Hits.Kind[at] = layers.LastKind[ray];
        this->Hits.Cell[at] = NoCell;
        AppendRay(rays, ray, this->Rays);
      });
    this->Hits.CellsRead = 0;
  }

  RayBatch Rays;
  HitBatch Hits;
  RayBatch::Array<std::size_t> From;
};

}

std::uint64_t SurfaceTracer::FindBlocked(const RayBatch& rays, std::int64_t& cellsRead) const
{
  HitBatch hits;
  this->Trace(rays, hits);
  cellsRead += hits.CellsRead;
  std::uint64_t blocked = 0;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    blocked |= static_cast<std::uint64_t>(hits.Kind[ray] != HitKind::None) << ray;
  }
  return blocked;
}

void SurfaceTracer::FindNext(const RayBatch& rays, HitBatch& hits) const
{
  hits.Clear(rays.Count);
}

void SurfaceTracer::FindLayers(const RayBatch& rays, LayerBatch& layers) const
{
  while (layers.Open != 0)
  {
    RestOfRays rest(rays, layers);
    this->FindNext(rest.Rays, rest.Hits);
    layers.CellsRead += rest.Hits.CellsRead;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rest.Rays.Count); ++i)
    {
      if (rest.Hits.Surface[i] != Frame::NoSurface)
      {
        layers.Append(rest.From[i], rest.Hits.Depth[i], rest.Hits.Kind[i], rest.Hits.Surface[i],
          rest.Hits.Cell[i]);
      }
      else
      {
        layers.Close(rest.From[i]);
      }
    }
  }
}

SearchedCells SurfaceTracer::SearchCells(const RayBatch&, const RayCells& cells, HitBatch&) const
{
  return { cells.Rays, 0 };
}

}
