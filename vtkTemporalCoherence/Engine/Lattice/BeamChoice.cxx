// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/BeamChoice.h"

#include <hwy/base.h>

namespace TemporalCoherence
{
namespace
{

/// Voxels between rays from which on rays walk to their first hits: too few rays of a beam then
/// pass a cell for vectors to pay. Beams take 0.70 to 0.98 of the time of walks at 0.9 (spheres256,
/// marschner-lobb256, engine, bonsai, heptane; AVX2: 0.70 to 0.87), and 0.83 (spheres256) to 1.25
/// (heptane) at 1.1 to 1.3. Measured by CPU times of cold frames of 256 to 384 pixels a side.
constexpr double CoarsestPixel = 1.0;

/// Voxels between rays from which on rays walk to layers, one by one. Beams take 0.85 to 0.9 of the
/// time of walks at 2.2 (engine, bonsai; 0.3 to 0.5 at 1.0), 1.1 at 2.6 (heptane), and twice the
/// time at 4.
constexpr double CoarsestLayerPixel = 2.4;

/// Tiles with fewer wanted rays than this use walks.
constexpr int FewestRays = 16;

bool AreBeamUpTo(double coarsest, Traversal by, const RayBatch& rays, std::uint64_t wanted)
{
  if (by != Traversal::Fastest)
  {
    return by == Traversal::Beams && wanted != 0;
  }
  return rays.Count == RayBatch::Capacity &&
    static_cast<int>(hwy::PopCount(wanted)) >= FewestRays && SpacingOf(rays) < coarsest;
}

}

bool HasBeams(const TraceScene& scene)
{
  return scene.Active && scene.By != Traversal::Walks &&
    scene.Samples.Between == Interpolation::Linear && !scene.Isosurfaces.Isovalues.empty();
}

bool AreBeam(Traversal by, const RayBatch& rays, std::uint64_t wanted)
{
  return AreBeamUpTo(CoarsestPixel, by, rays, wanted);
}

bool AreBeam(const TraceScene& scene, const RayBatch& rays, std::uint64_t wanted)
{
  // Hints begin walks near surfaces, so walks are short: beams take 0.85 (bonsai) to 1.06 (engine)
  // of their time when the camera moved, and twice the time without vectors.
  const bool areShort = scene.By == Traversal::Fastest && scene.IsHinted;
  return !areShort && AreBeam(scene.By, rays, wanted);
}

bool AreLayerBeam(Traversal by, const RayBatch& rays, std::uint64_t wanted)
{
  return AreBeamUpTo(CoarsestLayerPixel, by, rays, wanted);
}

}
