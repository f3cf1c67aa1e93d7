// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CompositeTracer_h
#define TemporalCoherence_CompositeTracer_h

#include "Blending/BlendTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// Make a tracer of the light that a volume of one component emits and absorbs. The samples are
/// those of an image, with linear interpolation.
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeCompositeTracer(const BlendScene& scene);

}

#endif
