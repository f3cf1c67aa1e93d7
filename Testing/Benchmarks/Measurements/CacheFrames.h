// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_CacheFrames_h
#define Benchmarks_CacheFrames_h

#include "Stage.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// A moving camera, drawn cold and from the image cache at each of its accuracies.
namespace CacheFrames
{

/// What is measured of every frame.
enum Quantity : std::size_t
{
  FrameMs,
  QueryMs,
  TraceMs,
  ShadeMs,
  DefiniteHits,   ///< percent of the rays
  DefiniteMisses, ///< percent of the rays
  PossibleHits,   ///< percent of the rays
  SamplesPerRay,
  SamplesPerTracedRay, ///< all samples, those of definite hits too, by the traced rays
  DifferentPixels,     ///< percent that differ from the cold picture
  NumberOfQuantities
};
using Measures = std::array<double, NumberOfQuantities>;

/// What a quantity is called in JSON.
const char* NameOf(Quantity quantity);

/// A way to make frames: cold, or from the image cache at one accuracy.
struct Variant
{
  std::string Name;
  std::function<void(vtkTemporalCoherenceVolumeMapper*)> Set;
};

/// All of them, the cold one first.
const std::vector<Variant>& AllVariants();

/// How the camera moves from frame to frame.
struct Motion
{
  std::string Name;
  std::function<void(Stage&, int frame, int frames)> Move;
  bool SpaceLeaping = true;
};

Motion Orbit(double degrees);

/// The orbits, the zoom and the pan; and last the orbit of 2 degrees without space leaping.
std::vector<Motion> AllMotions();

/// One variant in one motion.
struct Summary
{
  std::string Variant;
  Measures Medians{};
  double WorstDifferentPixels = 0.0;
  double FramesFromCache = 0.0; ///< percent
};

/// A summary of each variant. Every view is drawn by all of them, so that ratios are from one run;
/// the first view, which fills the caches, is not measured.
std::vector<Summary> Run(
  Stage& stage, const Motion& motion, const std::vector<Variant>& variants, int frames);

}

#endif
