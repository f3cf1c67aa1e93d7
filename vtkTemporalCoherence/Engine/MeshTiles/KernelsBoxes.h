// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsBoxes_h
#define TemporalCoherence_KernelsBoxes_h

#include "Scene/RayBatch.h"
#include "Trees/MeshBoxes.h"

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

/// Which of some rays pass a box of index space between WalkBegin and a limit, one bit each. Rays
/// that pass within a margin of the box count, too.
/// \param limits of all rays, to the end of the last vector
std::uint64_t RaysThrough(const RayBatch& rays, std::uint64_t which,
  const RayBatch::Array<double>& limits, const FloatBox& box, double margin);

/// Of these, rays whose difference may be 0 there.
std::uint64_t RaysAcross(const RayBatch& rays, std::uint64_t which,
  const RayBatch::Array<double>& limits, const FloatBox& box, double margin,
  const NearlyLinear& differences);

/// Of some rays, those whose limits are not before a depth: t = depth PerDepth.
std::uint64_t RaysReaching(
  const RayBatch& rays, std::uint64_t which, const RayBatch::Array<double>& limits, double depth);

/// RaysThrough of all rays.
inline std::uint64_t RaysThrough(
  const RayBatch& rays, const RayBatch::Array<double>& limits, const FloatBox& box, double margin)
{
  const std::uint64_t others =
    rays.Count < RayBatch::Capacity ? ~std::uint64_t(0) << rays.Count : 0;
  return RaysThrough(rays, ~others, limits, box, margin);
}

}

#endif
