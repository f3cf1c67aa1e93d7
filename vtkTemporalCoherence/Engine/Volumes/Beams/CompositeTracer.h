// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CompositeTracer_h
#define TemporalCoherence_CompositeTracer_h

#include "Volumes/Beams/CompositeTables.h"
#include "Volumes/Medium/BlendTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the composite tracer of an image with one component and linear interpolation.
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeCompositeTracer(
  const BlendScene& scene, KeptTables* kept = nullptr);

}

#endif
