// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BallHint_h
#define Testing_BallHint_h

#include "Lattice/RayHint.h"

#include <algorithm>
#include <cmath>

// A hint: what somebody knows of where surfaces are. What a new kind of hint costs
// (Documentation/Extending.md).

namespace TemporalCoherence
{

/// Rays meet nothing before a ball in index space, and most of them nothing behind it.
class BallHint final : public RayHint
{
public:
  BallHint(const glm::dvec3& centre, double radius)
    : Centre(centre)
    , Radius(radius)
  {
  }

  bool Narrow(RayBatch& rays, KnownRays& known) const override
  {
    known.WalkEnd = rays.WalkEnd;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      const glm::dvec2 within = this->PartWithin(rays, i);
      rays.WalkBegin[i] = std::max(rays.WalkBegin[i], within.x);
      rays.WalkEnd[i] = std::min(rays.WalkEnd[i], within.y);
    }
    return true;
  }

  /// A ray that found nothing goes on behind the ball.
  bool Correct(
    const KnownRays& known, const HitBatch& hits, std::size_t ray, RayBatch& rays) const override
  {
    const bool isWrong = hits.Kind[ray] == HitKind::None && rays.WalkEnd[ray] < known.WalkEnd[ray];
    rays.WalkEnd[ray] = isWrong ? known.WalkEnd[ray] : rays.WalkEnd[ray];
    return isWrong;
  }

private:
  /// Where a ray enters and leaves the ball; where it passes by, twice the point nearest to it.
  glm::dvec2 PartWithin(const RayBatch& rays, std::size_t ray) const
  {
    const glm::dvec3 direction(
      rays.Direction[0][ray], rays.Direction[1][ray], rays.Direction[2][ray]);
    const glm::dvec3 toCentre =
      this->Centre - glm::dvec3(rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray]);
    const double square = glm::dot(direction, direction);
    const double nearest = glm::dot(toCentre, direction) / square;
    const glm::dvec3 beside = toCentre - nearest * direction;
    const double left = std::max(this->Radius * this->Radius - glm::dot(beside, beside), 0.0);
    const double half = std::sqrt(left / square);
    return { nearest - half, nearest + half };
  }

  glm::dvec3 Centre;
  double Radius;
};

}

#endif
