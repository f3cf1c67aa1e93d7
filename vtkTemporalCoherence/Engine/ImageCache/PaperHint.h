// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PaperHint_h
#define TemporalCoherence_PaperHint_h

#include "ImageCache/ImageQuery.h"
#include "Lattice/RayHint.h"

namespace TemporalCoherence
{

/// The paper's hint from a cached image: definite misses are not traced, a definite hit is refined
/// within a voxel or re-used with its colour, and possible hits are traced from the end of the
/// space that the image shows to be free.
class PaperHint : public RayHint
{
public:
  /// \param query       must outlive the hint
  /// \param isSolid     surfaces are those of THRESHOLD
  /// \param isParallel  kind of the projection
  /// \param interpolates definite hits are re-used from the image
  PaperHint(const ImageQuery& query, bool isSolid, bool isParallel, bool interpolates)
    : Query(query)
    , IsSolid(isSolid)
    , IsParallel(isParallel)
    , Interpolates(interpolates)
  {
  }

  bool Narrow(RayBatch& rays, KnownRays& known) const override;
  bool TakeOver(
    const KnownRays& known, const RayBatch& rays, std::size_t ray, Frame& frame) const override;
  bool Correct(
    const KnownRays& known, const HitBatch& hits, std::size_t ray, RayBatch& rays) const override;
  Told TellOf(const KnownRays& known, const RayBatch& rays, const HitBatch& hits,
    std::size_t ray) const override;

private:
  bool IsWrong(const KnownRays& known, const HitBatch& hits, std::size_t ray) const;

  const ImageQuery& Query;
  bool IsSolid;
  bool IsParallel;
  bool Interpolates;
};

}

#endif
