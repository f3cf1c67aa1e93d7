// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LightTracer_h
#define TemporalCoherence_LightTracer_h

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
  RayBatch::Array<double> Length;                           ///< may be infinite

  void Append(const glm::dvec3& origin, const glm::dvec3& direction, double length)
  {
    const std::size_t at = this->Count++;
    for (int a = 0; a < 3; ++a)
    {
      this->Origin[static_cast<std::size_t>(a)][at] = origin[a];
      this->Direction[static_cast<std::size_t>(a)][at] = direction[a];
    }
    this->Length[at] = length;
  }
};

/// Finds what surfaces let pass of the light that comes from some directions.
///
/// A ray begins a thousandth of the shortest cell edge away from its point, so that it does not
/// meet the surface there. It is traced like a ray of the picture.
class LightTracer
{
public:
  /// The arguments must outlive it.
  /// \param tracer of the key's surfaces, in walks: the rays have no common direction
  LightTracer(
    const FrameKey& key, const NormalSource& source, std::shared_ptr<const SurfaceTracer> tracer);

  /// Trace rays.
  /// \param passed what passes the surfaces that a ray meets: 0 to 1
  /// \return cells read
  std::int64_t Trace(const LightRays& rays, RayBatch::Array<float>& passed) const;

private:
  void SetUp(const LightRays& rays, RayBatch& batch) const;
  std::int64_t TraceOpaque(const RayBatch& batch, RayBatch::Array<float>& passed) const;
  void FindOpacities(HitList& hits, RayBatch::Array<float>& opacities) const;
  std::int64_t TraceLayers(
    const LightRays& rays, const RayBatch& batch, RayBatch::Array<float>& passed) const;

  const FrameKey& Key;
  const NormalSource& Source;
  std::shared_ptr<const SurfaceTracer> Tracer;
  RegionClipper Clipper;
  std::vector<float> Alphas; ///< AlphasOf the surfaces
  double Begin;              ///< where rays begin
};

/// Collects rays, and traces them in full batches.
/// \tparam Take called as take(tag, passed) with the result of each ray
template <typename Take>
class LightRayBatches
{
public:
  LightRayBatches(const LightTracer& tracer, const Take& take)
    : Tracer(tracer)
    , TakeResult(take)
  {
  }

  /// \param tag identifies the ray
  void Append(const glm::dvec3& origin, const glm::dvec3& direction, double length, std::size_t tag)
  {
    this->Tags[this->Rays.Count] = tag;
    this->Rays.Append(origin, direction, length);
    if (this->Rays.Count == RayBatch::Capacity)
    {
      this->Trace();
    }
  }

  /// Trace the rays that are left.
  /// \return cells read by all rays
  std::int64_t Finish()
  {
    if (this->Rays.Count > 0)
    {
      this->Trace();
    }
    return this->CellsRead;
  }

private:
  void Trace()
  {
    RayBatch::Array<float> passed;
    this->CellsRead += this->Tracer.Trace(this->Rays, passed);
    for (std::size_t i = 0; i < this->Rays.Count; ++i)
    {
      this->TakeResult(this->Tags[i], passed[i]);
    }
    this->Rays.Count = 0;
  }

  const LightTracer& Tracer;
  Take TakeResult;
  LightRays Rays;
  RayBatch::Array<std::size_t> Tags;
  std::int64_t CellsRead = 0;
};

}

#endif
