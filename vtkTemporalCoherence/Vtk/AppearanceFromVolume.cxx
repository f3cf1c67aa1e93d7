// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AppearanceFromVolume.h"

#include <vtkCamera.h>
#include <vtkCollection.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <limits>
#include <sstream>

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
  return light;
}

std::vector<Light> FindLights(vtkRenderer* renderer)
{
  std::vector<Light> lights;
  if (renderer->GetLightFollowCamera())
  {
    renderer->UpdateLightsGeometryToFollowCamera();
  }
  vtkLightCollection* sources = renderer->GetLights();
  vtkCollectionSimpleIterator at;
  sources->InitTraversal(at);
  while (vtkLight* source = sources->GetNextLight(at))
  {
    if (source->GetSwitch())
    {
      lights.push_back(MakeLight(source));
    }
  }
  if (sources->GetNumberOfItems() == 0 && renderer->GetAutomaticLightCreation())
  {
    // What the renderer would add when it renders into a window.
    Light headlight;
    headlight.Direction = ToVec(renderer->GetActiveCamera()->GetDirectionOfProjection());
    lights.push_back(headlight);
  }
  return lights;
}

glm::dvec3 ColorAt(vtkVolumeProperty* property, double value)
{
  glm::dvec3 color;
  if (property->GetColorChannels() == 3)
  {
    property->GetRGBTransferFunction()->GetColor(value, &color.x);
  }
  else
  {
    color = glm::dvec3(property->GetGrayTransferFunction()->GetValue(value));
  }
  return color;
}

}

bool FindIsovalues(vtkVolumeProperty* property, std::vector<double>& isovalues,
  std::vector<int>& places, std::string& error)
{
  isovalues.clear();
  places.clear();
  vtkContourValues* list = property->GetIsoSurfaceValues();
  const int count = list->GetNumberOfContours();
  for (int i = 0; i < count; ++i)
  {
    const double isovalue = list->GetValue(i);
    std::ostringstream what;
    if (!std::isfinite(isovalue))
    {
      what << "Isovalue " << i << " is " << isovalue
           << "; set a finite number with GetIsoSurfaceValues()->SetValue(" << i << ", value).";
    }
    else if (isovalues.size() == static_cast<std::size_t>(std::numeric_limits<std::int16_t>::max()))
    {
      what << "There are " << count << " isovalues, more than the " << isovalues.size()
           << " that can be drawn; shorten the list with SetNumberOfContours.";
    }
    if (!what.str().empty())
    {
      error = what.str();
      return false;
    }
    if (property->GetScalarOpacity()->GetValue(isovalue) > 0.0)
    {
      isovalues.push_back(isovalue);
      places.push_back(i);
    }
  }
  return true;
}

Appearance MakeAppearance(
  vtkVolumeProperty* property, vtkRenderer* renderer, const std::vector<double>& isovalues)
{
  Appearance appearance;
  for (const double isovalue : isovalues)
  {
    appearance.Colors.push_back(ColorAt(property, isovalue));
  }
  appearance.Shade = property->GetShade() != 0;
  if (appearance.Shade)
  {
    appearance.Ambient = property->GetAmbient();
    appearance.Diffuse = property->GetDiffuse();
    appearance.Specular = property->GetSpecular();
    appearance.SpecularPower = property->GetSpecularPower();
    appearance.Lights = FindLights(renderer);
  }
  return appearance;
}

}
