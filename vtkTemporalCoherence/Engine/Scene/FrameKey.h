// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameKey_h
#define TemporalCoherence_FrameKey_h

#include "Scene/Appearance.h"
#include "Scene/Field.h"
#include "Scene/Region.h"
#include "Scene/Surfaces.h"
#include "Scene/View.h"

namespace TemporalCoherence
{

/// Everything that a picture depends on, and nothing else: two frames with equal keys are equal.
struct FrameKey
{
  Field Samples;
  IndexTransform Transform;
  TemporalCoherence::Region Region;
  TemporalCoherence::View View;
  Surfaces Isosurfaces;
  TemporalCoherence::Appearance Appearance;
};

/// True if fields can differ in the values of their samples alone, and fingerprints tell in which.
/// Where cells are hidden or not alike, nobody asks.
bool AreAlike(const Field& a, const Field& b);

/// What changed between two frames, by part of the key.
struct FrameChange
{
  bool Data = false;    ///< samples, interpolation, transform, region
  bool Samples = false; ///< of the data, only values of samples
  bool View = false;
  bool Surfaces = false; ///< isovalues or mode
  bool Opacity = false;
  bool Raised = false; ///< of the surfaces, only the one isovalue, and upwards
  bool Appearance = false;
};

FrameChange CompareFrames(const FrameKey& last, const FrameKey& next);

/// True if no surface of a higher isovalue is met before those of a lower one, from outside. With
/// CROSSING a ray may come out of hidden cells inside the lower one, having met no surface; and so
/// may one that leaves the region and comes back.
bool AreHitsOrdered(const FrameKey& key);

}

#endif
