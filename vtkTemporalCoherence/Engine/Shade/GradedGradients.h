// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GradedGradients_h
#define TemporalCoherence_GradedGradients_h

#include "Scene/RayBatch.h"
#include "Shade/SurfaceNormal.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// IndexGradients for a field whose samples lie at coordinates: differences are divided by the
/// distance between the samples that they are taken of, as vtkRectilinearSynchronizedTemplates
/// does.
/// \pre query.Samples.Grid
void GradedGradients(const GradientQuery& query, std::size_t count,
  const std::array<RayBatch::Array<double>, 3>& points,
  const std::array<RayBatch::Array<double>, 3>& directions,
  const RayBatch::Array<std::int16_t>& surfaces, std::array<RayBatch::Array<double>, 3>& gradients);

}

#endif
