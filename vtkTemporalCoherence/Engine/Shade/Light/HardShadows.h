// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HardShadows_h
#define TemporalCoherence_HardShadows_h

#include "Scene/Appearance.h"
#include "Shade/Light/KeptShadows.h"
#include "Shade/Light/LightTracer.h"
#include "Shade/Shader.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Find the share of a light that surfaces let through to hits, by one ray for each hit that the
/// light may brighten and of which nothing is kept.
/// \param light    position in the appearance
/// \param kept     is read, and gets what is found; null: nothing is kept
/// \param arriving result, up to the end of the last vector
/// \return cells read
std::int64_t FindHardShadows(const LightTracer& tracer, const Appearance& appearance,
  std::size_t light, const HitList& hits, KeptShadows* kept, RayBatch::Array<float>& arriving);

}

#endif
