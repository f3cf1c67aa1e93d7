// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BeamChoice_h
#define TemporalCoherence_BeamChoice_h

#include "Trace/SurfaceTracer.h"

#include <cstdint>

namespace TemporalCoherence
{

/// True if the rays of tiles can go through a field as beams, where pixels are fine.
bool HasBeams(const Field& field, const Surfaces& surfaces);

/// True if the rays of tiles may go through a scene as beams.
bool HasBeams(const TraceScene& scene);

/// True if some rays of a tile, one bit each, are to go through active cells as a beam.
/// \pre the field has beams
bool AreBeam(Traversal by, const RayBatch& rays, std::uint64_t wanted);

/// The same for first surfaces.
bool AreBeam(const TraceScene& scene, const RayBatch& rays, std::uint64_t wanted);

/// The same for layers.
bool AreLayerBeam(Traversal by, const RayBatch& rays, std::uint64_t wanted);

}

#endif
