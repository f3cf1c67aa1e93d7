// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceNormal_h
#define TemporalCoherence_SurfaceNormal_h

#include "Scene/Field.h"
#include "Scene/Surfaces.h"
#include "Shade/HitRays.h"

#include <array>
#include <cstddef>
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
  /// Differences from the isovalues are taken, so that infinities do no harm.
  const std::vector<double>* Isovalues = nullptr;
};

/// Hits of a tile, and the gradients to be found there. Rays without a hit may be among them, whose
/// points may lie outside of the field.
struct GradientTile
{
  using Vectors = std::array<RayBatch::Array<double>, 3>; ///< by axis

  const HitRays& Rays;                           ///< at least 1, to the end of the last vector
  const RayBatch::Array<std::int16_t>& Surfaces; ///< positions in the list of isovalues
  Vectors& Gradients; ///< result: per index step, finite up to the end of the last vector
  /// Of a mesh, that were hit, or NoCell. Null: they are not known.
  const RayBatch::Array<CellNumber>* Cells = nullptr;
  /// Of hits in a mesh. Null: none is known.
  const KnownGradients* Known = nullptr;
  /// Surfaces have their isovalue, caps do not. Null: it is not known which these are.
  const RayBatch::Array<HitKind>* Kinds = nullptr;
};

/// Find the gradients of a field of any kind.
inline void IndexGradients(const GradientQuery& query, const GradientTile& tile)
{
  query.Samples.Kind->FindGradients(query, tile);
}

/// The same for a uniform field.
void UniformGradients(const GradientQuery& query, const GradientTile& tile);

}

#endif
