// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayHint_h
#define TemporalCoherence_RayHint_h

#include "Scene/Frame.h"
#include "Scene/RayBatch.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// What is known about the rays of a tile before they are traced, as arrays over rays.
struct KnownRays
{
  RayBatch::Array<double> WalkBegin, WalkEnd; ///< where rays were to walk before they were narrowed
  RayBatch::Array<Answer> Answers;
  RayBatch::Array<double> Free;        ///< no surface nearer than this t is known of
  RayBatch::Array<double> Hit;         ///< t of a definite hit
  RayBatch::Array<double> Column, Row; ///< of a definite hit, in pixels of the kept image
  RayBatch::Array<std::int32_t> Pixel; ///< of the kept image, where the ray stopped; or -1
};

/// Tells where on its rays a tile has to be searched. A hint saves time: it shortens walks, and
/// where the trace shows that it was wrong the ray is traced once more.
///
/// This base knows nothing: rays walk as they are. A new kind of hint overrides what it knows.
/// Every function is safe from many threads.
class RayHint
{
public:
  RayHint() = default;
  virtual ~RayHint() = default;
  RayHint(const RayHint&) = delete;
  RayHint& operator=(const RayHint&) = delete;

  /// Shorten the walks of rays to where something may be found.
  /// \return false if all of them are known to meet nothing
  virtual bool Narrow(RayBatch& rays, KnownRays& known) const
  {
    static_cast<void>(rays);
    static_cast<void>(known);
    return true;
  }

  /// Write a hit that is taken over as it is, with its normal and its colour.
  /// \return false if there is none for the ray
  virtual bool TakeOver(
    const KnownRays& known, const RayBatch& rays, std::size_t ray, Frame& frame) const
  {
    static_cast<void>(known);
    static_cast<void>(rays);
    static_cast<void>(ray);
    static_cast<void>(frame);
    return false;
  }

  /// True if what a ray found shows that the hint was wrong about it; its walk is then the one to
  /// trace instead.
  virtual bool Correct(
    const KnownRays& known, const HitBatch& hits, std::size_t ray, RayBatch& rays) const
  {
    static_cast<void>(known);
    static_cast<void>(hits);
    static_cast<void>(ray);
    static_cast<void>(rays);
    return false;
  }

  /// What was known about a ray before, and whether it had to be traced.
  struct Told
  {
    Answer Known = Answer::PossibleHit;
    bool WasTraced = true;
  };
  virtual Told TellOf(
    const KnownRays& known, const RayBatch& rays, const HitBatch& hits, std::size_t ray) const
  {
    static_cast<void>(known);
    const bool wasTraced =
      rays.WalkBegin[ray] < rays.WalkEnd[ray] || hits.Kind[ray] == HitKind::Cap;
    return { wasTraced ? Answer::PossibleHit : Answer::DefiniteMiss, wasTraced };
  }
};

}

#endif
