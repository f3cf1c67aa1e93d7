// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BeamChoice_h
#define TemporalCoherence_BeamChoice_h

#include "Lattice/SurfaceTracer.h"

#include <cstdint>

namespace TemporalCoherence
{

/// True if the rays of tiles may go through a scene as beams, where pixels are fine.
bool HasBeams(const TraceScene& scene);

/// True if some rays of a tile, one bit each, are to go through active cells as a beam.
/// \pre the field has beams
bool AreBeam(Traversal by, const RayBatch& rays, std::uint64_t wanted);

/// True if the rays of a tile go as a beam to their first surfaces.
bool AreBeam(const TraceScene& scene, const RayBatch& rays, std::uint64_t wanted);

/// True if the rays of a tile go as a beam through layers.
bool AreLayerBeam(Traversal by, const RayBatch& rays, std::uint64_t wanted);

}

#endif
