// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HitRays_h
#define TemporalCoherence_HitRays_h

#include "Scene/TileHits.h"

#include <cstddef>

namespace TemporalCoherence
{

/// The rays of some hits, and how far along them the hits lie. Kernels compute the points where
/// they need them.
struct HitRays
{
  using Vectors = WorldDirections;

  HitRays() = default;
  HitRays(const HitRays&) = delete;
  void operator=(const HitRays&) = delete;

  std::size_t Count = 0;
  RayBatch::Array<double> T; ///< finite
  glm::dvec3 Eye{ 0.0 };     ///< where all rays begin, unless they are apart
  bool AreApart = false;
  Vectors Begin; ///< where each ray begins, if they are apart
  Vectors Own;
  const Vectors* Direction = &Own; ///< of unit length; where the rays were set up, or Own

  glm::dvec3 DirectionAt(std::size_t i) const { return At(*this->Direction, i); }

  /// The point of a hit, bit-identical to the kernels' points.
  glm::dvec3 PointAt(std::size_t i) const
  {
    return (this->AreApart ? At(this->Begin, i) : this->Eye) + this->T[i] * this->DirectionAt(i);
  }

private:
  static glm::dvec3 At(const Vectors& vectors, std::size_t i)
  {
    return { vectors[0][i], vectors[1][i], vectors[2][i] };
  }
};

}

#endif
