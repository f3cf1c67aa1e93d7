// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsBoxes_h
#define TemporalCoherence_KernelsBoxes_h

#include "Mesh/Tree/MeshBoxes.h"
#include "Scene/RayBatch.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// Bounds of the values in a cell, by the point in index space: within Bend of
/// Gradient . point + AtZero.
struct NearlyLinear
{
  glm::dvec3 Gradient{ 0.0 };
  double AtZero = 0.0;
  double Bend = std::numeric_limits<double>::infinity();
};

/// Bits of the rays in `which` that pass a box of index space between WalkBegin and their limit.
/// Rays within a margin of the box count, too.
/// \param limits of all rays, to the end of the last vector
std::uint64_t RaysThrough(const RayBatch& rays, std::uint64_t which,
  const RayBatch::Array<double>& limits, const FloatBox& box, double margin);

/// RaysThrough, but only rays whose difference may be 0 in the box.
std::uint64_t RaysAcross(const RayBatch& rays, std::uint64_t which,
  const RayBatch::Array<double>& limits, const FloatBox& box, double margin,
  const NearlyLinear& differences);

/// Bits of the rays in `which` whose limit reaches a depth: t = depth PerDepth.
std::uint64_t RaysReaching(
  const RayBatch& rays, std::uint64_t which, const RayBatch::Array<double>& limits, double depth);

/// RaysThrough for all rays of a batch.
inline std::uint64_t RaysThrough(
  const RayBatch& rays, const RayBatch::Array<double>& limits, const FloatBox& box, double margin)
{
  const std::uint64_t others =
    rays.Count < RayBatch::Capacity ? ~std::uint64_t(0) << rays.Count : 0;
  return RaysThrough(rays, ~others, limits, box, margin);
}

}

#endif
