// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsEmission_h
#define TemporalCoherence_KernelsEmission_h

#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Medium/TransferTables.h"
#include "Volumes/Medium/VolumeCell.h"
#include "Volumes/Medium/VolumeLights.h"
#include "Volumes/Medium/VolumeSegments.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace TemporalCoherence
{

/// Kernels that add the light of cell segments, in the widest vectors of the machine. Every kind of
/// vectors gives the same bits.
namespace EmissionKernels
{

/// Rays end once their transmittance is this small.
constexpr float LeastPassed = 1.0f / 1024.0f;

/// A volume that emits and absorbs light.
struct EmittingVolume
{
  const TransferTables& Tables;
  const GradientTable& ByGradient;
  const VolumeLights* Lights; ///< null: unshaded
  glm::vec3 PerStep{ 1.0f };  ///< scales gradients in bins to the units of ByGradient
  glm::mat3 WorldFromGradient{ 1.0f };

  float Sharpness() const { return this->Lights ? this->Lights->Sharpness() : 1.0f; }
  bool HasColoredLights() const { return this->Lights && !this->Lights->AreWhite; }
  bool HasGradients() const { return this->Lights || !this->ByGradient.Opacities.empty(); }
};

/// Data of a tile's rays for lighting.
struct LitRays
{
  /// \param seen light of the rays so far
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

  /// For each ray the unit direction in the world, then the world point at RayBatch::Begin, each
  /// padded to four numbers.
  static constexpr int Row = 8;
  alignas(64) std::array<float, RayBatch::Capacity * Row> Rows{};

  /// Transmittance of the segments so far, estimated in one step each. It sets the accuracy of the
  /// segments behind, and depends on the ray alone.
  RayBatch::Array<float> Expected;
};

/// Light of segments with nothing in front of them.
struct SegmentSums
{
  template <typename T>
  using Array = VolumeSegments::Array<T>;
  static constexpr float Never = 1e30f;

  Array<float> Passed;               ///< transmittance
  std::array<Array<float>, 3> Color; ///< multiplied by its opacity
  Array<float> First;                ///< t of the first visible point, or Never
};

/// Composite segments behind the light of their rays so far.
/// \param segments get a tail of zeros, for the last vector
void AddSegments(const EmittingVolume& volume, LitRays& rays, VolumeSegments& segments,
  const VolumeCells& cells, BlendedRays& seen);

}

}

#endif
