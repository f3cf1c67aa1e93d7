// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HitOpacities_h
#define TemporalCoherence_HitOpacities_h

#include "Scene/Surfaces.h"
#include "Shade/Shader.h"

#include <array>

namespace TemporalCoherence
{

/// Find the opacities of hits. Those of surfaces, of gradients and of an array's values are
/// multiplied.
/// \param hits      know these values, if opacities depend on them
/// \param gradients of the field at the hits, per index step, if opacities depend on them
void FindHitOpacities(const Surfaces& surfaces, const HitList& hits,
  const std::array<RayBatch::Array<double>, 3>& gradients, RayBatch::Array<float>& opacities);

}

#endif
