// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsRays_h
#define TemporalCoherence_KernelsRays_h

#include "Trace/RaySource.h"

namespace TemporalCoherence
{

/// RaySource::SetUp, in vectors of the widest kind that the machine has.
void SetUpRays(
  const RaySource& source, const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays);

}

#endif
