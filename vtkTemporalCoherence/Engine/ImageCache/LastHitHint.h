// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LastHitHint_h
#define TemporalCoherence_LastHitHint_h

#include "Trace/RayHint.h"

namespace TemporalCoherence
{

/// What the exact picture of one isovalue tells about the hits of another one in the same view.
/// When the isovalue rises, the hit of a ray that begins below it moves away. When it falls, the
/// hit comes nearer, unless the ray now begins above it.
class LastHitHint : public RayHint
{
public:
  /// \param last must outlive the hint
  LastHitHint(const Frame& last, bool isRaised, bool isParallel)
    : Last(last)
    , IsRaised(isRaised)
    , IsParallel(isParallel)
  {
  }

  bool Narrow(RayBatch& rays, KnownRays& known) const override;
  bool Correct(
    const KnownRays& known, const HitBatch& hits, std::size_t ray, RayBatch& rays) const override;

private:
  const Frame& Last;
  bool IsRaised;
  bool IsParallel; ///< kind of the projection
};

}

#endif
