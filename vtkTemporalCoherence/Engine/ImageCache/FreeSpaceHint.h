// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FreeSpaceHint_h
#define TemporalCoherence_FreeSpaceHint_h

#include "ImageCache/ImageHint.h"

namespace TemporalCoherence
{

/// The hint of BOUNDED: walks begin at the end of the space that a cached image shows to be free.
class FreeSpaceHint : public ImageHint
{
public:
  using ImageHint::ImageHint;

  /// A surface right behind the free space counts as a definite hit.
  Told TellOf(const KnownRays& known, const RayBatch& rays, const HitBatch& hits,
    std::size_t ray) const override;
};

}

#endif
