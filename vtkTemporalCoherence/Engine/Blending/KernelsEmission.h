// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsEmission_h
#define TemporalCoherence_KernelsEmission_h

#include "Blending/BlendTracer.h"
#include "Blending/KernelsVolumeSegments.h"
#include "Blending/TransferTables.h"
#include "Blending/VolumeLights.h"
#include "Blending/VolumeSegments.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Kernels that add the light of cell segments, in the widest vectors of the machine. Every kind of
/// vectors gives the same bits.
namespace EmissionKernels
{

/// Less light than this from behind is not seen.
constexpr float LeastPassed = 1.0f / 1024.0f;

/// A volume that emits and absorbs light.
struct EmittingVolume
{
  const TransferTables& Tables;
  const GradientTable& ByGradient;
  const VolumeLights* Lights; ///< null: it is not shaded
  glm::vec3 PerStep{ 1.0f };  ///< scales gradients in bins to those that ByGradient knows
  glm::mat3 WorldFromGradient{ 1.0f };

  bool HasGradients() const { return this->Lights || !this->ByGradient.Opacities.empty(); }
};

/// The rays of a tile, as far as lights ask for them.
struct LitRays
{
  std::array<RayBatch::Array<float>, 3> Direction; ///< in the world, of unit length
  std::array<RayBatch::Array<float>, 3> Begin;     ///< where t is RayBatch::Begin
};

/// Add what is seen in segments to what their rays have seen.
/// \param around the samples around the cells, in bins; unused without gradients
void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const SamplesAround& around, BlendedRays& seen);

/// The same for samples that vectors gather.
/// \pre no cell is at the boundary
void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint8_t>& samples, float perValue, BlendedRays& seen);
void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int8_t>& samples, float perValue, BlendedRays& seen);
void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint16_t>& samples, float perValue, BlendedRays& seen);
void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int16_t>& samples, float perValue, BlendedRays& seen);

}

}

#endif
