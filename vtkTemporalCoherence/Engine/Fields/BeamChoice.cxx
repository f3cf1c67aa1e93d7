// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/BeamChoice.h"

#include <hwy/base.h>

#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Voxels between rays from which on they walk: then a cell of a beam is passed by so few rays that
/// vectors of them do not pay. Beams and walks cost the same at 0.75 (engine) to 0.9 (spheres256,
/// marschner-lobb256, bonsai), and at 0.43 walks cost 1.3 to 1.8 times as much. Measured by cold
/// frames of `Benchmark --scenarios routes` at zooms of 0.3 to 2.2.
constexpr double CoarsestPixel = 0.75;

/// Fewer rays of a tile than this walk.
constexpr int FewestRays = 16;

}

double SpacingOf(const RayBatch& rays)
{
  constexpr std::size_t middle = 36, right = 7, above = 56;
  const double t = rays.WalkBegin[middle];
  glm::dvec3 direction, alongX, alongY;
  for (int a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<std::size_t>(a);
    const auto at = [&](std::size_t ray)
    { return rays.Origin[axis][ray] + t * rays.Direction[axis][ray]; };
    direction[a] = rays.Direction[axis][middle];
    alongX[a] = at(right) - at(0);
    alongY[a] = at(above) - at(0);
  }
  const double area = std::abs(glm::dot(direction, glm::cross(alongX, alongY)));
  return std::sqrt(area / glm::length(direction)) / (TileSize - 1);
}

bool HasBeams(const Field& field, const Surfaces& surfaces)
{
  return field.Between == Interpolation::Linear && !surfaces.Isovalues.empty();
}

bool AreBeam(const TraceScene& scene, const RayBatch& rays, std::uint64_t wanted)
{
  if (scene.By == Traversal::Beams)
  {
    return wanted != 0;
  }
  // Walks that a hint begins near surfaces are short: as beams, moved cameras cost 0.85 (bonsai)
  // to 1.06 (engine) times as much, and twice as much without vectors.
  return !scene.IsHinted && rays.Count == RayBatch::Capacity &&
    static_cast<int>(hwy::PopCount(wanted)) >= FewestRays && SpacingOf(rays) < CoarsestPixel;
}

}
