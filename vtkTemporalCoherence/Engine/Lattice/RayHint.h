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

/// Knowledge about the rays of a tile before they are traced, as arrays over rays.
struct KnownRays
{
  RayBatch::Array<double> WalkBegin, WalkEnd; ///< the walks before they were narrowed
  RayBatch::Array<Answer> Answers;
  RayBatch::Array<double> Free;        ///< t up to which no surface is expected
  RayBatch::Array<double> Hit;         ///< t of a definite hit
  RayBatch::Array<double> Column, Row; ///< of a definite hit, in pixels of the cached image
  RayBatch::Array<std::int32_t>
    Pixel; ///< of the cached image, where the query of the ray stopped; or -1
};

/// Tells which parts of a tile's rays to search. A hint saves time by shortening walks. If the
/// trace shows that it was wrong about a ray, that ray is traced again.
///
/// This base class knows nothing and changes no walk. A new kind of hint overrides what it knows
/// about. All functions are thread-safe.
class RayHint
{
public:
  RayHint() = default;
  virtual ~RayHint() = default;
  RayHint(const RayHint&) = delete;
  RayHint& operator=(const RayHint&) = delete;

  /// Shorten the walks of rays to where surfaces may be.
  /// \return false if all rays are known to miss
  virtual bool Narrow(RayBatch& rays, KnownRays& known) const
  {
    static_cast<void>(rays);
    static_cast<void>(known);
    return true;
  }

  /// Write a hit that is re-used without a trace, with its normal and colour.
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

  /// True if the result of a trace shows that the hint was wrong about a ray. The ray's walk is
  /// then set to the part to trace instead.
  virtual bool Correct(
    const KnownRays& known, const HitBatch& hits, std::size_t ray, RayBatch& rays) const
  {
    static_cast<void>(known);
    static_cast<void>(hits);
    static_cast<void>(ray);
    static_cast<void>(rays);
    return false;
  }

  /// The answer known for a ray before its trace, and whether the ray was traced.
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
