// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Appearance_h
#define TemporalCoherence_Appearance_h

#include "Scene/ArrayLooks.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// One light in world coordinates; colours are multiplied by the light's intensity.
struct Light
{
  bool Positional = false;
  glm::dvec3 Position{ 0.0 };
  glm::dvec3 Direction{ 0.0, 0.0, -1.0 }; ///< unit vector in which the light shines
  glm::dvec3 Diffuse{ 1.0 };
  glm::dvec3 Specular{ 1.0 };
  double ConeAngle = 180.0;                ///< degrees from axis to rim; 90 or more: no spot
  double Exponent = 1.0;                   ///< fall-off inside a spot's cone
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 }; ///< constant, linear, quadratic in distance
  bool CastsShadows = false;
  /// The radius of a positional light that casts shadows. Of another light, the tangent of its
  /// angular radius. 0: shadows are hard.
  double Size = 0.0;

  bool CastsSoftShadows() const { return this->CastsShadows && this->Size > 0.0; }
  bool CastsHardShadows() const { return this->CastsShadows && this->Size == 0.0; }
};

/// Ambient occlusion: surfaces nearby keep light away from a point. Ambient and diffuse light are
/// multiplied by 1 - Strength (1 - open), where `open` is the share of directions around the
/// normal, weighted by their cosines, in which no drawn surface stops light within the radius. A
/// translucent surface stops the share that is its opacity.
struct AmbientOcclusion
{
  double Radius = 0.0;   ///< in the world; 0: no occlusion
  double Strength = 1.0; ///< 0 to 1

  bool IsOn() const { return this->Radius > 0.0 && this->Strength > 0.0; }
};

inline bool operator==(const AmbientOcclusion& a, const AmbientOcclusion& b)
{
  return a.Radius == b.Radius && a.Strength == b.Strength;
}

/// How hits become colours: VTK's Phong model, or the plain colour where `Shade` is false. All
/// numbers are finite, and no product of a colour, a coefficient and a light leaves the range of
/// floats.
struct Appearance
{
  std::vector<glm::dvec3> Colors; ///< RGB in [0, 1], one for each isovalue
  /// Colours at the values of an array, instead; null: none.
  std::shared_ptr<const ArrayColors> ByArray;
  bool Shade = false;
  double Ambient = 0.1;
  double Diffuse = 0.7;
  double Specular = 0.2;
  double SpecularPower = 10.0;
  std::vector<Light> Lights;
  /// Light both sides of a surface. If false, only its outside is lit: the side of lower values.
  bool TwoSided = true;
  /// The shown colour is scale * lit colour + shift, clamped to [0, 1].
  double ColorScale = 1.0, ColorShift = 0.0;
  AmbientOcclusion Occlusion;
  bool ColorByAnswer = false; ///< yellow: pixels that the image cache did not serve

  /// True if surfaces keep light away from one another: each may change the colours of all.
  bool HasMutualLight() const
  {
    return this->Shade &&
      (this->Occlusion.IsOn() ||
        std::any_of(this->Lights.begin(), this->Lights.end(),
          [](const Light& light) { return light.CastsShadows; }));
  }
};

/// True if two lights shine on any point from the same direction.
inline bool ShineAlike(const Light& a, const Light& b)
{
  return a.Positional == b.Positional &&
    (a.Positional ? a.Position == b.Position : a.Direction == b.Direction);
}

inline bool operator==(const Light& a, const Light& b)
{
  return a.Positional == b.Positional && a.Position == b.Position && a.Direction == b.Direction &&
    a.Diffuse == b.Diffuse && a.Specular == b.Specular && a.ConeAngle == b.ConeAngle &&
    a.Exponent == b.Exponent && a.Attenuation == b.Attenuation &&
    a.CastsShadows == b.CastsShadows && a.Size == b.Size;
}

inline bool operator==(const Appearance& a, const Appearance& b)
{
  return a.Colors == b.Colors && AreSame(a.ByArray, b.ByArray) && a.Shade == b.Shade &&
    a.Ambient == b.Ambient && a.Diffuse == b.Diffuse && a.Specular == b.Specular &&
    a.SpecularPower == b.SpecularPower && a.Lights == b.Lights && a.TwoSided == b.TwoSided &&
    a.ColorScale == b.ColorScale && a.ColorShift == b.ColorShift && a.Occlusion == b.Occlusion &&
    a.ColorByAnswer == b.ColorByAnswer;
}

}

#endif
