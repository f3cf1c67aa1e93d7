// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameOptions_h
#define TemporalCoherence_FrameOptions_h

#include "ImageCache/ImageCache.h"
#include "ImageCache/ImageQuery.h"
#include "Isomap/Isomap.h"
#include "Render/LayerLimit.h"
#include "Render/ReusePlan.h"
#include "Scene/StandIn.h"
#include "Shade/Light/SurfaceLight.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>

namespace TemporalCoherence
{

/// When pixels at edges get more than one ray.
enum class Antialiasing : std::uint8_t
{
  Off,
  WhenStill, ///< in a frame that differs in nothing from the last one
  Always     ///< in each frame
};

/// A frame from fewer rays: they lie on a grid, the pixels between them are interpolated, and the
/// tiles where that is worst are traced whole.
struct FewerRays
{
  double Distance = 1.0; ///< pixels between rays along each axis; 1: each pixel has a ray
  /// If it shows that the rays of the grid take too long, they get farther apart, up to this
  /// distance.
  double MostDistance = 1.0;
  std::int64_t Tiles = std::numeric_limits<std::int64_t>::max(); ///< most tiles to trace whole
  /// Elapsed time / allowed time of the frame. Several threads call it before they trace a tile of
  /// the grid or of the picture. May be null: there is no hurry.
  std::function<double()> Elapsed;

  bool AreAsked() const { return this->Distance > 1.0; }
  bool HasTime() const { return !this->Elapsed || this->Elapsed() < 1.0; }
};

/// A frame that does not wait for samples. Tiles whose samples were not read in time are shown from
/// a stand-in, or stay as they were, until a later frame.
struct Impatience
{
  /// Null: frames wait.
  std::shared_ptr<const TemporalCoherence::StandIn> StandIn;
  std::int64_t Deadline = BrickCache::Patient; ///< time to give up reading (GiveUpAt)
  /// Several threads call it before they trace a tile. Null with StandIn.
  std::function<bool()> HasTime;

  bool IsAsked() const { return this->StandIn != nullptr; }
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
  FewerRays Fewer;
  Impatience Reading;        ///< of samples in bricks
  bool ReportsTiles = false; ///< trace tiles in parts, with a progress report before each part
};

}

#endif
