// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageHint_h
#define TemporalCoherence_ImageHint_h

#include "ImageCache/ImageQuery.h"
#include "Trace/RayHint.h"

namespace TemporalCoherence
{

/// Base of hints from a cached image: definite misses are not traced, and possible hits only from
/// where the image tells no more.
class ImageHint : public RayHint
{
public:
  /// \param query   must outlive the hint
  /// \param isSolid surfaces are those of THRESHOLD
  ImageHint(const ImageQuery& query, bool isSolid)
    : Query(query)
    , IsSolid(isSolid)
  {
  }

  bool Narrow(RayBatch& rays, KnownRays& known) const override;
  bool Correct(
    const KnownRays& known, const HitBatch& hits, std::size_t ray, RayBatch& rays) const override;
  Told TellOf(const KnownRays& known, const RayBatch& rays, const HitBatch& hits,
    std::size_t ray) const override;

protected:
  const ImageQuery& Query;

private:
  bool IsWrong(const KnownRays& known, const HitBatch& hits, std::size_t ray) const;

  bool IsSolid;
};

}

#endif
