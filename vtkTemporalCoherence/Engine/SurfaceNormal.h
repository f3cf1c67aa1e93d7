// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceNormal_h
#define TemporalCoherence_SurfaceNormal_h

#include "Field.h"
#include "RayBatch.h"
#include "Surfaces.h"

#include <array>

namespace TemporalCoherence
{

/// Gradients of the field at points, as arrays over hits.
///
/// The gradient is that of central differences at the samples (one-sided at the boundary of the
/// field), continued between samples as the field is: trilinearly, or from the nearest sample.
/// \param field       samples
/// \param finiteRange smallest and largest finite sample
/// \param isovalue    differences from it are taken, so that samples which are not finite do no
///                    harm
/// \param count       number of points, at most RayBatch::Capacity
/// \param points      positions in index space, within the field's box, by axis
/// \param gradients   the gradient per index step, by axis
void IndexGradients(const Field& field, const glm::dvec2& finiteRange, double isovalue, int count,
  const std::array<RayBatch::Array<double>, 3>& points,
  std::array<RayBatch::Array<double>, 3>& gradients);

/// Outward normal, in index space, of the face of the box [0, dimensions - 1] that a point lies on.
/// \return the zero vector if the point is not on a face
glm::dvec3 BoxFaceNormal(const glm::dvec3& point, const glm::ivec3& dimensions);

}

#endif
