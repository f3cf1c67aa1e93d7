// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformBandTracer_h
#define TemporalCoherence_UniformBandTracer_h

#include "Isomap/BandTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// The BandTracer of uniform fields, for the type of the scene's samples: the rays of a tile go as
/// a beam where that is faster.
/// \throws std::bad_alloc
std::shared_ptr<const BandTracer> MakeUniformBandTracer(const BandScene& scene);

}

#endif
