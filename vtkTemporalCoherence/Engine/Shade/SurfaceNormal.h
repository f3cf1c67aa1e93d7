// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceNormal_h
#define TemporalCoherence_SurfaceNormal_h

#include "Scene/Field.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"

#include <array>
#include <vector>

namespace TemporalCoherence
{

/// Gradients of the field at the hits of a tile.
///
/// The gradient is that of central differences at the samples (one-sided at the boundary of the
/// field), continued between samples as the field is: trilinearly, or from the nearest sample.
struct GradientQuery
{
  Field Samples;
  glm::dmat4 IndexFromWorld{ 1.0 };
  glm::dvec2 FiniteRange{ 0.0 }; ///< smallest and largest finite sample
  /// Differences from them are taken, so that samples which are not finite do no harm.
  const std::vector<double>* Isovalues = nullptr;
};

/// \param count      at least 1
/// \param points     in the world, to the end of the last vector
/// \param directions of the rays, to the end of the last vector
/// \param surfaces   positions in the list of isovalues
/// \param gradients  found: per index step, by axis
void IndexGradients(const GradientQuery& query, std::size_t count,
  const std::array<RayBatch::Array<double>, 3>& points,
  const std::array<RayBatch::Array<double>, 3>& directions,
  const RayBatch::Array<std::int16_t>& surfaces, std::array<RayBatch::Array<double>, 3>& gradients);

}

#endif
