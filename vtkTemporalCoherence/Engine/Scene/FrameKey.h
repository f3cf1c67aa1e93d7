// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameKey_h
#define TemporalCoherence_FrameKey_h

#include "Scene/Appearance.h"
#include "Scene/Blending.h"
#include "Scene/Field.h"
#include "Scene/Region.h"
#include "Scene/Surfaces.h"
#include "Scene/View.h"

namespace TemporalCoherence
{

/// Everything that a picture depends on, and nothing else. Two frames with equal keys are equal.
struct FrameKey
{
  Field Samples;
  IndexTransform Transform;
  TemporalCoherence::Region Region;
  TemporalCoherence::View View;
  Surfaces Isosurfaces;
  TemporalCoherence::Appearance Appearance;
  Blending Volume; ///< if it is on, there are no isosurfaces
};

/// True if two fields differ in the values of their samples at most, so that fingerprints can find
/// the changed samples. False if cells are flagged as hidden, or if the kind of field has no
/// fingerprints.
bool AreAlike(const Field& a, const Field& b);

/// The changes between two frames, by part of the key.
struct FrameChange
{
  bool Data = false;    ///< samples, interpolation, transform, region
  bool Samples = false; ///< the data changed in nothing but values of samples
  bool View = false;
  bool Surfaces = false; ///< isovalues or mode
  bool Opacity = false;
  bool Appearance = false;
  bool Volume = false; ///< how the volume is blended
};

FrameChange CompareFrames(const FrameKey& last, const FrameKey& next);

/// True if the rays of two frames meet the same layers, whatever their opacities and colours.
bool MeetSameLayers(const FrameKey& a, const FrameKey& b);

}

#endif
