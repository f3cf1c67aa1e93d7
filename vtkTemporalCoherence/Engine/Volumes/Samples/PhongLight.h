// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PhongLight_h
#define TemporalCoherence_PhongLight_h

#include "Scene/Appearance.h"
#include "Scene/Blending.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// A place that is lit, in the world.
struct LitPlace
{
  glm::dvec3 At;
  glm::dvec3 Ray;     ///< direction from which it is seen, of unit length
  glm::dvec3 Outward; ///< against the gradient, of any length; 0: only ambient light falls on it
};

/// Shade a colour at a place by VTK's Phong model.
glm::dvec3 LightUp(const Material& material, const Appearance& lights, const LitPlace& place,
  const glm::dvec3& color);

}

#endif
