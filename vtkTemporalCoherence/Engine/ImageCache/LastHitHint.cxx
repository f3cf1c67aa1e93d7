// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCache/LastHitHint.h"

#include "Scene/FramePlanes.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// A walk to a known depth goes farther by this share of it, so that the cell of the hit is not
/// missed.
constexpr double DepthError = 1e-9;

}

bool LastHitHint::Narrow(RayBatch& rays, KnownRays& known) const
{
  known.WalkEnd = rays.WalkEnd;
  if (this->IsRaised)
  {
    BeginAtFirstEntries(this->Last, this->IsParallel, rays);
    return true;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const auto pixel = static_cast<std::size_t>(rays.Pixel[i]);
    if (this->Last.Kinds[pixel] == HitKind::Entry)
    {
      const double t = this->Last.Depth[pixel];
      rays.WalkEnd[i] = std::min(rays.WalkEnd[i], t + DepthError * std::abs(t));
    }
  }
  return true;
}

bool LastHitHint::Correct(
  const KnownRays& known, const HitBatch& hits, std::size_t ray, RayBatch& rays) const
{
  if (rays.WalkEnd[ray] < known.WalkEnd[ray] && hits.Kind[ray] == HitKind::None)
  {
    rays.WalkEnd[ray] = known.WalkEnd[ray];
    return true;
  }
  return false;
}

}
