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

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
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

/// The lights that are on, as the renderer finds them when it draws into a window.
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
  bool areHeadlights = true;
  while (vtkLight* source = sources->GetNextLight(at))
  {
    if (source->GetSwitch())
    {
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
    // Alone, it is where the camera is, even if it was left behind (LightFollowCameraOff).
    lights.front().Direction = ToVec(renderer->GetActiveCamera()->GetDirectionOfProjection());
  }
  return lights;
}

glm::dvec3 ColorAt(vtkVolumeProperty* property, int component, double value)
{
  glm::dvec3 color;
  if (property->GetColorChannels(component) == 3)
  {
    property->GetRGBTransferFunction(component)->GetColor(value, &color.x);
  }
  else
  {
    color = glm::dvec3(property->GetGrayTransferFunction(component)->GetValue(value));
  }
  return color;
}

}

bool FindSurfaces(vtkVolumeProperty* property, int component, Surfaces& surfaces,
  std::vector<int>& places, std::string& error)
{
  std::vector<double>& isovalues = surfaces.Isovalues;
  isovalues.clear();
  surfaces.Opacities.clear();
  places.clear();
  vtkContourValues* list = property->GetIsoSurfaceValues();
  const int count = list->GetNumberOfContours();
  std::set<double> found;
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
    const double opacity = property->GetScalarOpacity(component)->GetValue(isovalue);
    if (opacity > 0.0 && found.insert(isovalue).second)
    {
      isovalues.push_back(isovalue);
      surfaces.Opacities.push_back(std::min(opacity, 1.0));
      places.push_back(i);
    }
  }
  const auto isOpaque = [](double opacity) { return opacity == 1.0; };
  if (std::all_of(surfaces.Opacities.begin(), surfaces.Opacities.end(), isOpaque))
  {
    surfaces.Opacities.clear();
  }
  return true;
}

GradientOpacity MakeGradientOpacity(
  vtkVolumeProperty* property, int component, const glm::dvec3& distances)
{
  // Nodes are joined by straight lines, but for those with a midpoint or a sharpness of their own.
  constexpr int ManyNodes = 4096;
  GradientOpacity made;
  if (property->GetDisableGradientOpacity(component) || !property->HasGradientOpacity(component))
  {
    return made;
  }
  vtkPiecewiseFunction* function = property->GetGradientOpacity(component);
  bool isStraight = true;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // position, value, midpoint, sharpness
    function->GetNodeValue(i, node);
    isStraight = isStraight && node[2] == 0.5 && node[3] == 0.0;
    made.Nodes.emplace_back(node[0], node[1]);
  }
  if (!isStraight)
  {
    const double first = made.Nodes.front().x, last = made.Nodes.back().x;
    made.Nodes.clear();
    for (int i = 0; i < ManyNodes; ++i)
    {
      const double at = first + (last - first) * i / (ManyNodes - 1);
      made.Nodes.emplace_back(at, function->GetValue(at));
    }
  }
  for (glm::dvec2& node : made.Nodes)
  {
    node.y = std::min(std::max(node.y, 0.0), 1.0);
  }
  if (std::all_of(
        made.Nodes.begin(), made.Nodes.end(), [](const glm::dvec2& node) { return node.y == 1.0; }))
  {
    made.Nodes.clear();
  }
  made.PerStep = (distances.x + distances.y + distances.z) / 3.0 / distances;
  return made;
}

bool IsOpaque(vtkVolumeProperty* property, int component)
{
  Surfaces surfaces;
  std::vector<int> places;
  std::string error;
  return FindSurfaces(property, component, surfaces, places, error) && surfaces.Opacities.empty() &&
    MakeGradientOpacity(property, component, glm::dvec3(1.0)).Nodes.empty();
}

Appearance MakeAppearance(vtkVolumeProperty* property, int component, vtkRenderer* renderer,
  const std::vector<double>& isovalues)
{
  Appearance appearance;
  for (const double isovalue : isovalues)
  {
    appearance.Colors.push_back(ColorAt(property, component, isovalue));
  }
  appearance.Shade = property->GetShade() != 0;
  if (appearance.Shade)
  {
    appearance.Ambient = property->GetAmbient(component);
    appearance.Diffuse = property->GetDiffuse(component);
    appearance.Specular = property->GetSpecular(component);
    appearance.SpecularPower = property->GetSpecularPower(component);
    appearance.Lights = FindLights(renderer);
    appearance.TwoSided = renderer->GetTwoSidedLighting() != 0;
    if (appearance.Lights.empty())
    {
      // What polygons look like without a light: lit evenly, and not black.
      appearance.Ambient += appearance.Diffuse;
    }
  }
  return appearance;
}

}
