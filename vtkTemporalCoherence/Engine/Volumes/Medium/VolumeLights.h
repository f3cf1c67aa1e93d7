// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumeLights_h
#define TemporalCoherence_VolumeLights_h

#include "Scene/Appearance.h"
#include "Scene/Blending.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace TemporalCoherence
{

/// A light for kernels. Its colours include the reflectances of the material.
struct VolumeLight
{
  bool IsPositional = false, IsSpot = false;
  glm::vec3 Position{ 0.0f }, Toward{ 0.0f }; ///< Toward: of unit length, against its direction
  glm::vec3 Diffuse{ 0.0f }, Specular{ 0.0f };
  glm::vec3 Attenuation{ 0.0f };
  float CosineOfCone = 0.0f;
  double Exponent = 1.0;
};

/// The lights of a volume.
struct VolumeLights
{
  /// \throws std::bad_alloc
  VolumeLights(const Appearance& appearance, const Material& material)
    : Ambient(static_cast<float>(material.Ambient))
    , Glow(material.Glow)
    , SpecularPower(material.SpecularPower)
    , AreTwoSided(appearance.TwoSided)
    , AreShiny(material.Specular != 0.0)
  {
    this->AreWhite = IsGrey(this->Glow);
    constexpr double pi = 3.14159265358979323846;
    for (const Light& light : appearance.Lights)
    {
      VolumeLight made;
      made.IsPositional = light.Positional;
      made.IsSpot = light.ConeAngle < 90.0;
      made.Position = light.Position;
      made.Toward = -light.Direction;
      made.Diffuse = material.Diffuse * light.Diffuse;
      made.Specular = material.Specular * light.Specular;
      made.Attenuation = light.Attenuation;
      made.CosineOfCone = static_cast<float>(std::cos(light.ConeAngle * pi / 180.0));
      made.Exponent = light.Exponent;
      this->Diffuse += Largest(made.Diffuse);
      this->Specular += Largest(made.Specular);
      this->AreWhite &= IsGrey(made.Diffuse) && IsGrey(made.Specular);
      this->All.push_back(made);
    }
  }

  /// True if light depends on where a ray runs.
  bool AskForRays() const
  {
    return this->AreShiny ||
      std::any_of(this->All.begin(), this->All.end(),
        [](const VolumeLight& light) { return light.IsPositional; });
  }

  /// How fast light changes with the normal, relative to one light on a matt surface.
  float Sharpness() const
  {
    const float power = this->AreShiny ? static_cast<float>(this->SpecularPower) : 0.0f;
    return std::max(1.0f, this->Diffuse) + 0.5f * power * this->Specular;
  }

  std::vector<VolumeLight> All;
  float Ambient;
  glm::vec3 Glow;
  double SpecularPower;
  float Diffuse = 0.0f, Specular = 0.0f; ///< sums over all lights, of their brightest channels
  bool AreTwoSided, AreShiny;
  bool AreWhite = true; ///< all channels are equal

private:
  static float Largest(const glm::vec3& color) { return std::max({ color.x, color.y, color.z }); }
  static bool IsGrey(const glm::vec3& color) { return color.x == color.y && color.x == color.z; }
};

}

#endif
