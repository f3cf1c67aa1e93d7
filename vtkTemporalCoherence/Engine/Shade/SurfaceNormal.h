// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceNormal_h
#define TemporalCoherence_SurfaceNormal_h

#include "Scene/Field.h"
#include "Scene/HitRays.h"
#include "Scene/Surfaces.h"

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Gradients of the field at the hits of a tile.
///
/// Gradients are central differences at the samples, one-sided at the boundary of the field and
/// beside a sample that is not a number.
/// Between samples they are interpolated as the field is: trilinearly, or from the nearest sample.
struct GradientQuery
{
  const Field& Samples; ///< not a copy: threads would wait for each other to count its pointers
  glm::dmat4 IndexFromWorld{ 1.0 };
  glm::dvec2 FiniteRange{ 0.0 }; ///< smallest and largest finite sample
  /// Gradients are computed from differences from the isovalues: so infinities do no harm.
  const std::vector<double>* Isovalues = nullptr;
};

/// Hits of a tile, and their gradients. Rays without a hit may be among them, with points outside
/// of the field.
struct GradientTile
{
  using Vectors = std::array<RayBatch::Array<double>, 3>; ///< by axis

  const HitRays& Rays;                           ///< at least 1, to the end of the last vector
  const RayBatch::Array<SurfaceIndex>& Surfaces; ///< positions in the list of isovalues
  Vectors& Gradients; ///< result: per index step, finite up to the end of the last vector
  /// Hit cells of a mesh, or NoCell. Null: unknown.
  const RayBatch::Array<CellNumber>* Cells = nullptr;
  /// Known gradients of hits in a mesh. Null: none.
  const KnownGradients* Known = nullptr;
  /// Surfaces have their isovalue, caps do not. Null: unknown kinds.
  const RayBatch::Array<HitKind>* Kinds = nullptr;
};

/// Find the gradients of a uniform field.
void UniformGradients(const GradientQuery& query, const GradientTile& tile);

}

#endif
