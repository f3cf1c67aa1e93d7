// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsBoxes_h
#define TemporalCoherence_KernelsBoxes_h

#include "Scene/RayBatch.h"
#include "Trees/MeshBoxes.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Which rays pass a box of index space between WalkBegin and a limit, one bit each. Rays that pass
/// within a margin of the box count, too.
/// \param limits of all rays, to the end of the last vector
std::uint64_t RaysThrough(
  const RayBatch& rays, const RayBatch::Array<double>& limits, const FloatBox& box, double margin);

}

#endif
