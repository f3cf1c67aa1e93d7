// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsDistinct_h
#define TemporalCoherence_KernelsDistinct_h

#include "Lattice/SurfaceTracer.h"
#include "Scene/RayBatch.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The distinct cell numbers of rays.
struct DistinctCells
{
  std::size_t Count = 0;
  RayBatch::Array<std::uint32_t> Numbers;
  RayBatch::Array<std::uint64_t> Rays; ///< rays with each number, one bit each
};

/// Find the distinct numbers of rays, in the order of their first rays.
/// \param which one bit for each ray that counts
/// \param numbers initialised up to the capacity of a batch
void FindDistinct(
  const RayBatch::Array<std::uint32_t>& numbers, std::uint64_t which, DistinctCells& distinct);

/// Find the ranks of the cells of rays.
/// \pre they are below 2^32
void FindRanks(const RayCells& cells, RayBatch::Array<std::uint32_t>& ranks);

}

#endif
