// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PaperHint_h
#define TemporalCoherence_PaperHint_h

#include "ImageCache/ImageHint.h"

namespace TemporalCoherence
{

/// The hint of PAPER: a definite hit is refined within a voxel, or re-used with its colour.
class PaperHint : public ImageHint
{
public:
  /// \param interpolates definite hits are re-used from the image
  PaperHint(const ImageQuery& query, bool isSolid, bool isParallel, bool interpolates)
    : ImageHint(query, isSolid)
    , IsParallel(isParallel)
    , Interpolates(interpolates)
  {
  }

  bool Narrow(RayBatch& rays, KnownRays& known) const override;
  bool TakeOver(
    const KnownRays& known, const RayBatch& rays, std::size_t ray, Frame& frame) const override;

private:
  bool IsParallel; ///< kind of the projection
  bool Interpolates;
};

}

#endif
