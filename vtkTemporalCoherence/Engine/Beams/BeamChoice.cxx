// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Beams/BeamChoice.h"

#include <hwy/base.h>

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

bool HasBeams(const Field& field, const Surfaces& surfaces)
{
  return field.Between == Interpolation::Linear && !surfaces.Isovalues.empty();
}

bool HasBeams(const TraceScene& scene)
{
  return scene.Active && scene.By != Traversal::Walks && HasBeams(scene.Samples, scene.Isosurfaces);
}

bool AreBeam(Traversal by, const RayBatch& rays, std::uint64_t wanted)
{
  if (by != Traversal::Fastest)
  {
    return by == Traversal::Beams && wanted != 0;
  }
  return rays.Count == RayBatch::Capacity &&
    static_cast<int>(hwy::PopCount(wanted)) >= FewestRays && SpacingOf(rays) < CoarsestPixel;
}

bool AreBeam(const TraceScene& scene, const RayBatch& rays, std::uint64_t wanted)
{
  // Walks that a hint begins near surfaces are short: as beams, moved cameras cost 0.85 (bonsai)
  // to 1.06 (engine) times as much, and twice as much without vectors.
  const bool areShort = scene.By == Traversal::Fastest && scene.IsHinted;
  return !areShort && AreBeam(scene.By, rays, wanted);
}

}
