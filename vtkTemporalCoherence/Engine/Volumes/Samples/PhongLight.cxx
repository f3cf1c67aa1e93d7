// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/PhongLight.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// The share of a light that arrives, and the direction to the light.
struct Arrival
{
  double Share;
  glm::dvec3 Toward;
};

Arrival ArrivalOf(const Light& light, const glm::dvec3& at)
{
  if (!light.Positional)
  {
    return { 1.0, -light.Direction };
  }
  const glm::dvec3 way = at - light.Position;
  const double distance = glm::length(way);
  const glm::dvec3 along = way / distance;
  const glm::dvec3& fading = light.Attenuation;
  const double weakened = fading.x + distance * (fading.y + distance * fading.z);
  double share = weakened > 0.0 ? 1.0 / weakened : 1.0;
  if (light.ConeAngle < 90.0)
  {
    const double cosine = glm::dot(along, light.Direction);
    const bool isInCone = cosine > 0.0 && cosine >= std::cos(glm::radians(light.ConeAngle));
    share = isInCone ? share * std::pow(cosine, light.Exponent) : 0.0;
  }
  return { share, -along };
}

}

glm::dvec3 LightUp(const Material& material, const Appearance& lights, const LitPlace& place,
  const glm::dvec3& color)
{
  glm::dvec3 shown = material.Ambient * color + material.Glow;
  const double length = glm::length(place.Outward);
  if (length > 0.0 && std::isfinite(length))
  {
    const glm::dvec3 normal = place.Outward / length;
    for (const Light& light : lights.Lights)
    {
      const Arrival arrival = ArrivalOf(light, place.At);
      const double cosine = glm::dot(normal, arrival.Toward);
      const double matt = lights.TwoSided ? std::abs(cosine) : cosine;
      if (matt > 0.0)
      {
        const glm::dvec3 mirrored = 2.0 * cosine * normal - arrival.Toward;
        const double towardEye = -glm::dot(mirrored, place.Ray);
        const double shine = towardEye > 0.0 ? std::pow(towardEye, material.SpecularPower) : 0.0;
        shown += arrival.Share *
          (material.Diffuse * matt * light.Diffuse * color +
            std::max(material.Specular, 0.0) * shine * light.Specular);
      }
    }
  }
  return glm::clamp(shown, 0.0, 1.0);
}

}
