// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Slabs_h
#define Benchmarks_Slabs_h

#include "MixingLayer.h"

#include <cstddef>
#include <functional>

/// Takes the samples of some slices, x fastest.
/// \param first slice
/// \param count of slices
/// \return false to stop
using TakeSlab = std::function<bool(int first, int count, const void* samples)>;

/// Make a volume slab by slab, by two threads. The next slab is made while one is taken, so that
/// three threads work. Only two slabs are in memory.
/// \param slices of a slab; the last one may have fewer
/// \return false if `take` stopped
bool ForEachSlab(
  const MixingLayer& layer, TemporalCoherence::ScalarType type, int slices, const TakeSlab& take);

/// Slices of a slab of about 32 MiB; at least one.
int SlicesOfSlab(const glm::ivec3& dimensions, TemporalCoherence::ScalarType type);

#endif
