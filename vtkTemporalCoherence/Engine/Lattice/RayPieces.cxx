// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/RayPieces.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// A batch of ray pieces, at most one for each ray.
struct PieceBatch
{
  RayBatch Rays;
  HitBatch Hits; ///< the last surfaces of the rays; then their hits in these pieces
  RayBatch::Array<std::size_t> Owners;
};

/// Append the piece of a ray between two distances.
/// \param last surface that the ray has met
void AppendPiece(const RayBatch& rays, std::size_t ray, const glm::dvec2& ends,
  const HitBatch& last, PieceBatch& pieces)
{
  const auto at = static_cast<std::size_t>(pieces.Rays.Count);
  pieces.Owners[at] = ray;
  AppendRay(rays, ray, pieces.Rays);
  pieces.Rays.Begin[at] = ends.x;
  pieces.Rays.End[at] = ends.y;
  pieces.Rays.WalkBegin[at] = std::max(rays.WalkBegin[ray], ends.x);
  pieces.Rays.WalkEnd[at] = std::min(rays.WalkEnd[ray], ends.y);
  pieces.Hits.Depth[at] = last.Depth[ray];
  pieces.Hits.Surface[at] = last.Surface[ray];
  pieces.Hits.Kind[at] = last.Kind[ray];
  pieces.Hits.Cell[at] = last.Cell[ray];
}

/// Copy the hit of a piece to its ray.
void TakeHit(const HitBatch& found, std::size_t i, std::size_t ray, HitBatch& hits)
{
  hits.Depth[ray] = found.Depth[i];
  hits.Surface[ray] = found.Surface[i];
  hits.Kind[ray] = found.Kind[i];
  hits.Cell[ray] = found.Cell[i];
}

}

RayPieces::RayPieces(const RegionClipper& clipper, const RayBatch& rays)
{
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    this->Pieces[ray] = clipper.PiecesOf(rays, ray);
  }
}

std::uint64_t RayPieces::Clip(std::size_t piece, RayBatch& rays) const
{
  std::uint64_t which = 0;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    const bool hasPiece = piece < this->CountOf(ray);
    const glm::dvec2 ends = hasPiece ? this->EndsOf(ray, piece) : glm::dvec2(rays.Begin[ray]);
    rays.Begin[ray] = ends.x;
    rays.End[ray] = ends.y;
    rays.WalkBegin[ray] = std::max(rays.WalkBegin[ray], ends.x);
    rays.WalkEnd[ray] = std::min(rays.WalkEnd[ray], ends.y);
    which |= static_cast<std::uint64_t>(hasPiece) << ray;
  }
  return which;
}

void FindInPieces(
  const RegionClipper& clipper, const RayBatch& rays, HitBatch& hits, const FindSurfaces& find)
{
  const auto count = static_cast<std::size_t>(rays.Count);
  const RayPieces pieces(clipper, rays);
  HitBatch next;
  next.Clear(rays.Count);
  for (std::size_t piece = 0; piece < RegionClipper::MostPieces; ++piece)
  {
    PieceBatch batch;
    batch.Hits.CellsRead = 0;
    for (std::size_t ray = 0; ray < count; ++ray)
    {
      if (piece < pieces.CountOf(ray) && next.Kind[ray] == HitKind::None)
      {
        const glm::dvec2& ends = pieces.EndsOf(ray, piece);
        if (hits.Surface[ray] == Frame::NoSurface || ends.y > hits.Depth[ray])
        {
          AppendPiece(rays, ray, ends, hits, batch);
        }
      }
    }
    if (batch.Rays.Count > 0)
    {
      find(batch.Rays, batch.Hits);
      for (std::size_t i = 0; i < static_cast<std::size_t>(batch.Rays.Count); ++i)
      {
        TakeHit(batch.Hits, i, batch.Owners[i], next);
      }
      next.CellsRead += batch.Hits.CellsRead;
    }
  }
  hits = next;
}

void FindLayersWithin(const RegionClipper& clipper, const SurfaceTracer& tracer,
  const RayBatch& rays, LayerBatch& layers)
{
  if (!clipper.HasPieces())
  {
    tracer.FindLayers(rays, layers);
    return;
  }
  const RayPieces pieces(clipper, rays);
  for (std::size_t piece = 0; piece < RegionClipper::MostPieces && layers.Open != 0; ++piece)
  {
    RayBatch parts = rays;
    std::uint64_t which = pieces.Clip(piece, parts) & layers.Open;
    ForEachRay(which,
      [&](std::size_t ray)
      {
        // A piece that ends before the last surface is done.
        const bool isAhead = layers.LastSurface[ray] == Frame::NoSurface ||
          pieces.EndsOf(ray, piece).y > layers.LastDistance[ray];
        which &= ~(static_cast<std::uint64_t>(!isAhead) << ray);
      });
    // A ray that meets nothing more in this piece goes on to the next one.
    const std::uint64_t open = layers.Open;
    layers.Open = which;
    tracer.FindLayers(parts, layers);
    std::uint64_t isDone = 0;
    ForEachRay(which,
      [&](std::size_t ray) { isDone |= static_cast<std::uint64_t>(layers.IsDone(ray)) << ray; });
    layers.Open = open & ~isDone;
  }
  layers.Open = 0;
}

}
