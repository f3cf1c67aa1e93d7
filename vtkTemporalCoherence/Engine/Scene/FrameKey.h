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

#include <variant>

namespace TemporalCoherence
{

/// Everything that a picture depends on, and nothing else. Two frames with equal keys are equal.
struct FrameKey
{
  Field Samples;
  IndexTransform Transform;
  TemporalCoherence::Region Region;
  TemporalCoherence::View View;
  std::variant<Surfaces, Blending> Shown;
  TemporalCoherence::Appearance Appearance;

  bool IsBlended() const { return std::holds_alternative<Blending>(this->Shown); }

  /// \throws std::bad_variant_access if it is not blended
  const Blending& Blended() const { return std::get<Blending>(this->Shown); }
  Blending& Blended() { return std::get<Blending>(this->Shown); }

  /// Without isosurfaces if it is blended.
  const Surfaces& Isosurfaces() const
  {
    static const Surfaces none;
    return this->IsBlended() ? none : std::get<Surfaces>(this->Shown);
  }
  /// \throws std::bad_variant_access if it is blended
  Surfaces& EditIsosurfaces() { return std::get<Surfaces>(this->Shown); }
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
  bool Blending = false;
};

FrameChange CompareFrames(const FrameKey& last, const FrameKey& next);

/// True if the rays of two frames meet the same layers, whatever their opacities and colours.
bool MeetSameLayers(const FrameKey& a, const FrameKey& b);

}

#endif
