// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HardShadows_h
#define TemporalCoherence_HardShadows_h

#include "Scene/Appearance.h"
#include "Shade/Light/LightTracer.h"
#include "Shade/Shader.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Find the share of a light that surfaces let through to hits, by one ray for each hit that the
/// light may brighten.
/// \param arriving result, up to the end of the last vector
/// \return cells read
std::int64_t FindHardShadows(const LightTracer& tracer, const Appearance& appearance,
  const Light& light, const HitList& hits, RayBatch::Array<float>& arriving);

}

#endif
