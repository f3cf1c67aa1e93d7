// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HitColors_h
#define TemporalCoherence_HitColors_h

#include "Scene/Appearance.h"
#include "Shade/Shader.h"

#include <array>

namespace TemporalCoherence
{

/// Find the colours of hits without any light, by their surfaces or by the values of an array.
/// \param hits   know these values
/// \param colors result, to the end of the last vector: RGB by channel
void FindHitColors(
  const Appearance& appearance, const HitList& hits, std::array<RayBatch::Array<float>, 3>& colors);

}

#endif
