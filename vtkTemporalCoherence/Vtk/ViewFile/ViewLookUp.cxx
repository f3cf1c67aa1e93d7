// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ViewLookUp.h"

#include "Lattice/RaySource.h"
#include "Scene/Parallel.h"
#include "Scene/RayBatch.h"
#include "Scene/Tiles.h"

#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Write the pixels of a tile.
void LookUpTile(const RaySource& source, const ViewGeometry& geometry, const KnotImage& knots,
  double isovalue, const PixelRect& pixels, Frame& frame)
{
  RayBatch rays;
  source.SetUp(pixels.First, pixels.Size, rays);
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    const auto pixel = static_cast<std::size_t>(rays.Pixel[ray]);
    const KnotImage::Hit hit = knots.LookUp(pixel, isovalue);
    const bool isHit = hit.IsReached && rays.Begin[ray] < rays.End[ray];
    frame.Depth[pixel] =
      isHit ? rays.Begin[ray] + hit.Distance : std::numeric_limits<double>::infinity();
    frame.Isovalues[pixel] = isHit ? 0 : Frame::NoSurface;
    frame.Kinds[pixel] = !isHit                  ? HitKind::None
      : hit.Direction == ValueDirection::Falling ? HitKind::Exit
                                                 : HitKind::Entry;
    frame.Answers[pixel] = !hit.IsSure ? Answer::PossibleHit
      : isHit                          ? Answer::DefiniteHit
                                       : Answer::DefiniteMiss;
    const int x = rays.Pixel[ray] % knots.Size.x, y = rays.Pixel[ray] / knots.Size.x;
    const glm::dvec3 along = geometry.Rays.RayThrough(x, y).Direction;
    const double sign = glm::dot(hit.Normal, along) > 0.0 ? -1.0 : 1.0;
    frame.Normals[pixel] = isHit ? glm::vec3(sign * hit.Normal) : glm::vec3(0.0f);
    frame.Colors[pixel] = {};
  }
}

}

void LookUpView(const ViewGeometry& geometry, const KnotImage& knots, double isovalue, Frame& frame)
{
  const IndexTransform transform{ geometry.WorldFromIndex, glm::inverse(geometry.WorldFromIndex) };
  Region region;
  region.Clips = geometry.Planes;
  const RaySource source(geometry.Rays, transform, glm::ivec3(geometry.Box.High + 1.5), region);
  frame.Resize(knots.Size);
  ParallelFor(NumberOfTiles(knots.Size), TileGrain,
    [&](std::int64_t tile)
    { LookUpTile(source, geometry, knots, isovalue, PixelsOfTile(knots.Size, tile), frame); });
}

}
