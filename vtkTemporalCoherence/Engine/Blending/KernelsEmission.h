// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsEmission_h
#define TemporalCoherence_KernelsEmission_h

#include "Blending/BlendTracer.h"
#include "Blending/KernelsVolumeSegments.h"
#include "Blending/TransferTables.h"
#include "Blending/VolumeCell.h"
#include "Blending/VolumeLights.h"
#include "Blending/VolumeSegments.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
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

  float Sharpness() const { return this->Lights ? this->Lights->Sharpness() : 1.0f; }
  bool HasColoredLights() const { return this->Lights && !this->Lights->AreWhite; }
  bool HasGradients() const { return this->Lights || !this->ByGradient.Opacities.empty(); }
};

/// The rays of a tile, as far as light asks for them.
struct LitRays
{
  /// Rays whose light so far is known.
  explicit LitRays(const BlendedRays& seen)
    : Expected(seen.Passed)
  {
  }

  void Set(std::size_t ray, const glm::vec3& direction, const glm::vec3& begin)
  {
    float* const row = &this->Rows[ray * Row];
    std::copy_n(&direction.x, 3, row);
    std::copy_n(&begin.x, 3, row + 4);
  }

  /// Of each ray its direction in the world, of unit length, and where t is RayBatch::Begin: both
  /// followed by a number without meaning.
  static constexpr int Row = 8;
  alignas(64) std::array<float, RayBatch::Capacity * Row> Rows{};

  /// The share of light that passes the segments so far, as each shows it in one step. It tells how
  /// exact what lies behind has to be, and depends on the ray alone.
  RayBatch::Array<float> Expected;
};

/// What segments add to their rays, if nothing lies before them.
struct SegmentSums
{
  template <typename T>
  using Array = VolumeSegments::Array<T>;
  static constexpr float Never = 1e30f;

  Array<float> Passed;               ///< share of the light from behind
  std::array<Array<float>, 3> Color; ///< multiplied by its opacity
  Array<float> First;                ///< t of what is seen first, or Never
};

/// Add what is seen in segments to what their rays have seen.
/// \param segments get a tail of zeros, for the last vector
void AddSegments(const EmittingVolume& volume, LitRays& rays, VolumeSegments& segments,
  const VolumeCells& cells, BlendedRays& seen);

}

}

#endif
