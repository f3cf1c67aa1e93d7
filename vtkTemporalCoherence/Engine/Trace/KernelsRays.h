// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsRays_h
#define TemporalCoherence_KernelsRays_h

#include "Trace/RaySource.h"

namespace TemporalCoherence
{

/// RaySource::SetUp in the widest vectors of the machine.
void SetUpRays(const RaySource& source, const glm::ivec2& first, const glm::ivec2& size,
  RayBatch& rays, WorldDirections* world = nullptr);

}

#endif
