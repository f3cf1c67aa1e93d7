// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageShares_h
#define TemporalCoherence_ImageShares_h

#include "Volumes/Medium/BlendTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the tracer of ShareTracer.h in vectors.
/// \pre the volume is an image of one component with linear interpolation, and the range of its
///   transfer function is not empty
/// \throws std::bad_alloc
std::shared_ptr<const BlendTracer> MakeImageShares(const BlendScene& scene);

}

#endif
