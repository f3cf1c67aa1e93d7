// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameOptions_h
#define TemporalCoherence_FrameOptions_h

#include "ImageCache/ImageCache.h"
#include "ImageCache/ImageQuery.h"
#include "Isomap/Isomap.h"
#include "Render/LayerLimit.h"
#include "Render/ReusePlan.h"
#include "Shade/Light/SurfaceLight.h"

#include <cstdint>

namespace TemporalCoherence
{

/// When pixels at edges get more than one ray.
enum class Antialiasing : std::uint8_t
{
  Off,
  WhenStill, ///< in a frame that differs in nothing from the last one
  Always     ///< in each frame
};

/// Options for making frames.
struct FrameOptions
{
  bool SpaceLeaping = true; ///< off: every cell along a ray is read (the paper's plain ray caster)
  ReuseSwitches Reuse;
  ReuseAccuracy Accuracy = ReuseAccuracy::Exact;
  bool InterpolateColors =
    false; ///< colour PAPER's definite hits from the cached image, without shading
  ImageCache::Options Images;
  Isomap::Options Map;
  LayerOptions Layers;
  LightOptions Light;
  Antialiasing Antialias = Antialiasing::Off;
  bool ReportsTiles = false; ///< trace tiles in parts, with a progress report before each part
};

}

#endif
