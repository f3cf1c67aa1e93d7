// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_OcclusionTracer_h
#define TemporalCoherence_OcclusionTracer_h

#include "Lattice/RegionClipper.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/FrameKey.h"
#include "Scene/RayBatch.h"
#include "Shade/Shader.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Rays from points on surfaces, in the world.
struct LightRays
{
  std::size_t Count = 0;
  std::array<RayBatch::Array<double>, 3> Origin, Direction; ///< directions of unit length
};

/// Finds what surfaces let pass of the light that comes from some directions.
///
/// A ray begins a thousandth of the shortest cell edge away from its point, so that it does not
/// meet the surface there, and ends where occlusion ends. It is traced like a ray of the picture.
class OcclusionTracer
{
public:
  /// The arguments must outlive it.
  /// \param tracer of the key's surfaces, in walks: the rays have no common direction
  OcclusionTracer(
    const FrameKey& key, const NormalSource& source, std::shared_ptr<const SurfaceTracer> tracer);

  /// Trace rays up to a distance.
  /// \param passed what passes the surfaces that a ray meets: 0 to 1
  /// \return cells read
  std::int64_t Trace(const LightRays& rays, double length, RayBatch::Array<float>& passed) const;

private:
  void SetUp(const LightRays& rays, double length, RayBatch& batch) const;
  std::int64_t TraceOpaque(const RayBatch& batch, RayBatch::Array<float>& passed) const;
  std::int64_t TraceLayers(
    const LightRays& rays, const RayBatch& batch, RayBatch::Array<float>& passed) const;

  const FrameKey& Key;
  const NormalSource& Source;
  std::shared_ptr<const SurfaceTracer> Tracer;
  RegionClipper Clipper;
  std::vector<float> Alphas; ///< AlphasOf the surfaces
  double Begin;              ///< where rays begin
};

}

#endif
