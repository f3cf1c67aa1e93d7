// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ArrivingLight_h
#define TemporalCoherence_ArrivingLight_h

#include "Scene/RayBatch.h"

#include <vector>

namespace TemporalCoherence
{

/// The light that other surfaces let through to the hits of a list, as shares of all light. Arrays
/// are set up to the end of the last vector.
struct ArrivingLight
{
  RayBatch::Array<float> FromAllSides; ///< dims ambient and diffuse light
  /// Of each light of the appearance. Empty if no light casts shadows.
  std::vector<RayBatch::Array<float>> OfLights;
};

}

#endif
