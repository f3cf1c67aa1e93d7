// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/LightsFromRenderer.h"

#include "Input/SettingCheck.h"

#include <vtkCamera.h>
#include <vtkCollection.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkRenderer.h>

namespace TemporalCoherence
{
namespace
{

glm::dvec3 ToVec(const double* v)
{
  return { v[0], v[1], v[2] };
}

glm::dvec3 UnitOrZero(const glm::dvec3& v)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// Make a light. Only the settings of its kind are checked.
bool CheckLight(vtkLight* source, int place, std::string& error)
{
  double position[3], focus[3];
  source->GetTransformedPosition(position);
  source->GetTransformedFocalPoint(focus);
  SettingCheck check({ "light", place, "the renderer" }, error);
  check("Intensity", source->GetIntensity(), Allowed::Intensity, "vtkLight::SetIntensity");
  check("Diffuse colour", source->GetDiffuseColor(), Allowed::Color, "vtkLight::SetDiffuseColor");
  check(
    "Specular colour", source->GetSpecularColor(), Allowed::Color, "vtkLight::SetSpecularColor");
  check("Position", position, Allowed::Place, "vtkLight::SetPosition or SetTransformMatrix");
  check("Focal point", focus, Allowed::Place, "vtkLight::SetFocalPoint or SetTransformMatrix");
  if (source->GetPositional())
  {
    check("Cone angle", source->GetConeAngle(), Allowed::Degrees, "vtkLight::SetConeAngle");
    check("Exponent", source->GetExponent(), Allowed::Exponent, "vtkLight::SetExponent");
    check("Attenuation", source->GetAttenuationValues(), Allowed::Attenuation,
      "vtkLight::SetAttenuationValues");
  }
  return check.HasPassed();
}

Light MakeLight(vtkLight* source)
{
  Light light;
  double position[3], focus[3];
  source->GetTransformedPosition(position);
  source->GetTransformedFocalPoint(focus);
  light.Positional = source->GetPositional() != 0;
  light.Position = ToVec(position);
  light.Direction = UnitOrZero(ToVec(focus) - ToVec(position));
  light.Diffuse = source->GetIntensity() * ToVec(source->GetDiffuseColor());
  light.Specular = source->GetIntensity() * ToVec(source->GetSpecularColor());
  light.ConeAngle = source->GetConeAngle();
  light.Exponent = source->GetExponent();
  light.Attenuation = ToVec(source->GetAttenuationValues());
  light.CastsShadows = !source->LightTypeIsHeadlight();
  const double distance = glm::length(ToVec(focus) - ToVec(position));
  light.Size = light.Positional ? 1.0 : (distance > 0.0 ? 1.0 / distance : 0.0);
  return light;
}

}

bool FindLights(vtkRenderer* renderer, std::vector<Light>& lights, std::string& error)
{
  if (renderer->GetLightFollowCamera())
  {
    renderer->UpdateLightsGeometryToFollowCamera();
  }
  vtkLightCollection* sources = renderer->GetLights();
  vtkCollectionSimpleIterator at;
  sources->InitTraversal(at);
  bool areHeadlights = true;
  int place = 0;
  for (; vtkLight* source = sources->GetNextLight(at); ++place)
  {
    if (source->GetSwitch())
    {
      if (!CheckLight(source, place, error))
      {
        return false;
      }
      lights.push_back(MakeLight(source));
      areHeadlights = areHeadlights && source->LightTypeIsHeadlight() && !source->GetPositional();
    }
  }
  if (lights.empty() && renderer->GetAutomaticLightCreation())
  {
    lights.emplace_back();
  }
  if (lights.size() == 1 && areHeadlights)
  {
    // A single headlight is at the camera, even if it was left behind (LightFollowCameraOff).
    lights.front().Direction = ToVec(renderer->GetActiveCamera()->GetDirectionOfProjection());
  }
  return true;
}

bool FindAmbientLight(vtkRenderer* renderer, std::optional<glm::dvec3>& found, std::string& error)
{
  glm::dvec3 sum(0.0);
  bool isPlainHeadlight = true;
  int place = 0, count = 0;
  vtkLightCollection* sources = renderer->GetLights();
  vtkCollectionSimpleIterator at;
  sources->InitTraversal(at);
  for (; vtkLight* source = sources->GetNextLight(at); ++place)
  {
    if (source->GetSwitch())
    {
      isPlainHeadlight = ++count == 1 && source->LightTypeIsHeadlight() &&
        !source->GetPositional() && source->GetIntensity() == 1.0;
      SettingCheck check({ "light", place, "the renderer" }, error);
      check(
        "Ambient colour", source->GetAmbientColor(), Allowed::Color, "vtkLight::SetAmbientColor");
      if (!check.HasPassed())
      {
        return false;
      }
      sum += source->GetIntensity() * ToVec(source->GetAmbientColor());
    }
  }
  found = isPlainHeadlight ? std::nullopt : std::make_optional(sum);
  return true;
}

}
