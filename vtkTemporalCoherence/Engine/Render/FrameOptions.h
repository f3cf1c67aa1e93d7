// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameOptions_h
#define TemporalCoherence_FrameOptions_h

#include "ImageCache/ImageCache.h"
#include "ImageCache/ImageQuery.h"
#include "Isomap/Isomap.h"
#include "Render/ReusePlan.h"

namespace TemporalCoherence
{

/// How frames are to be made.
struct FrameOptions
{
  bool SpaceLeaping = true; ///< off: every cell on the way is read (the paper's plain ray caster)
  ReuseSwitches Reuse;
  ReuseAccuracy Accuracy = ReuseAccuracy::Bounded;
  bool InterpolateColors = false; ///< PAPER's definite hits: from the cached image, not shaded
  ImageCache::Options Images;
  Isomap::Options Map;
  bool ReportsTiles = false; ///< tiles are worked on in parts, too, with a report before each
};

}

#endif
