// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsPlanes_h
#define TemporalCoherence_KernelsPlanes_h

#include "Scene/Frame.h"
#include "Scene/RayBatch.h"

namespace TemporalCoherence
{

/// Write the hits of a tile of 8 x 8 pixels, row by row, into the planes of a frame, in the widest
/// vectors of the machine: the same bits as StoreHit (FramePlanes.h) for each ray.
void StoreRows(const RayBatch& rays, const HitBatch& hits, const RayBatch::Array<Answer>& answers,
  bool isParallel, Frame& frame);

}

#endif
