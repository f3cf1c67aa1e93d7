// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/AppearanceFromVolume.h"

#include "Input/SettingCheck.h"
#include "Request/GradientOpacityFromVolume.h"
#include "Request/LightsFromRenderer.h"

#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkScalarsToColors.h>
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

glm::dvec3 ColorAt(const SurfaceLooks& looks, double value)
{
  vtkVolumeProperty* const property = looks.Property;
  const int component = looks.Component;
  glm::dvec3 color;
  if (looks.Table)
  {
    looks.Table->GetColor(value, &color.x);
  }
  else if (property->GetColorChannels(component) == 3)
  {
    property->GetRGBTransferFunction(component)->GetColor(value, &color.x);
  }
  else
  {
    color = glm::dvec3(property->GetGrayTransferFunction(component)->GetValue(value));
  }
  return color;
}

/// The position in a transfer function, for messages.
/// \param what the number is
std::string At(const char* what, double number)
{
  std::ostringstream where;
  where << "at " << what << " " << number;
  return where.str();
}

/// The object that has the looks, for messages.
const char* OwnerOf(const SurfaceLooks& looks)
{
  return looks.Table ? "the table of colours" : "the volume's property";
}

bool FindColors(const SurfaceLooks& looks, const std::vector<double>& isovalues,
  std::vector<glm::dvec3>& colors, std::string& error)
{
  for (const double isovalue : isovalues)
  {
    glm::dvec3 color;
    if (!FindColor(looks, "isovalue", isovalue, color, error))
    {
      return false;
    }
    colors.push_back(color);
  }
  return true;
}

}

bool FindColor(
  const SurfaceLooks& looks, const char* what, double value, glm::dvec3& color, std::string& error)
{
  color = ColorAt(looks, value);
  for (int channel = 0; channel < 3; ++channel)
  {
    if (!Allowed::Color.Holds(color[channel]))
    {
      SettingCheck check({ OwnerOf(looks) }, error);
      check(("Colour " + At(what, value)).c_str(), color[channel], Allowed::Color,
        looks.Table ? "SetTableValue or AddRGBPoint"
          : looks.Property->GetColorChannels(looks.Component) == 3
          ? "GetRGBTransferFunction()->AddRGBPoint"
          : "GetGrayTransferFunction()->AddPoint");
      return false;
    }
  }
  return true;
}

bool FindOpacity(
  const SurfaceLooks& looks, const char* what, double value, double& opacity, std::string& error)
{
  const double found = looks.Table
    ? looks.Table->GetOpacity(value)
    : looks.Property->GetScalarOpacity(looks.Component)->GetValue(value);
  if (!Allowed::Opacity.Holds(found))
  {
    SettingCheck check({ OwnerOf(looks) }, error);
    check(("Scalar opacity " + At(what, value)).c_str(), found, Allowed::Opacity,
      looks.Table ? "SetTableValue" : "GetScalarOpacity()->AddPoint");
    return false;
  }
  opacity = std::min(std::max(found, 0.0), 1.0);
  return true;
}

vtkContourValues* ChooseIsovalues(vtkVolumeProperty* property, vtkContourValues* other)
{
  vtkContourValues* const own = property->GetIsoSurfaceValues();
  const int count = own->GetNumberOfContours();
  const bool isUntouched = count == 0 || (count == 1 && own->GetValue(0) == 0.0);
  return other && isUntouched ? other : own;
}

bool FindSurfaces(vtkContourValues* list, vtkVolumeProperty* property, int component,
  Surfaces& surfaces, std::vector<int>& places, std::string& error)
{
  std::vector<double>& isovalues = surfaces.Isovalues;
  isovalues.clear();
  surfaces.Opacities.clear();
  places.clear();
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
    double opacity = 0.0;
    if (!FindOpacity({ property, component }, "isovalue", isovalue, opacity, error))
    {
      return false;
    }
    if (opacity > 0.0 && found.insert(isovalue).second)
    {
      isovalues.push_back(isovalue);
      surfaces.Opacities.push_back(opacity);
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

bool IsOpaque(vtkContourValues* list, vtkVolumeProperty* property, int component)
{
  Surfaces surfaces;
  GradientOpacity byGradient;
  std::vector<int> places;
  std::string error;
  return FindSurfaces(list, property, component, surfaces, places, error) &&
    surfaces.Opacities.empty() && MakeGradientOpacity(property, component, byGradient, error) &&
    byGradient.Nodes.empty();
}

bool MakeAppearance(const SurfaceLooks& looks, vtkRenderer* renderer,
  const std::vector<double>& isovalues, Appearance& appearance, std::string& error)
{
  vtkVolumeProperty* const property = looks.Property;
  const int component = looks.Component;
  appearance.Shade = property->GetShade() != 0;
  if (!FindColors(looks, isovalues, appearance.Colors, error))
  {
    return false;
  }
  if (!appearance.Shade)
  {
    return true;
  }
  appearance.Ambient = property->GetAmbient(component);
  appearance.Diffuse = property->GetDiffuse(component);
  appearance.Specular = property->GetSpecular(component);
  appearance.SpecularPower = property->GetSpecularPower(component);
  SettingCheck check({ "the volume's property" }, error);
  check("Ambient", appearance.Ambient, Allowed::Coefficient, "SetAmbient");
  check("Diffuse", appearance.Diffuse, Allowed::Coefficient, "SetDiffuse");
  check("Specular", appearance.Specular, Allowed::Coefficient, "SetSpecular");
  check("Specular power", appearance.SpecularPower, Allowed::SpecularPower, "SetSpecularPower");
  if (!check.HasPassed() || !FindLights(renderer, appearance.Lights, error))
  {
    return false;
  }
  appearance.TwoSided = renderer->GetTwoSidedLighting() != 0;
  if (appearance.Lights.empty())
  {
    // Without a light, surfaces are lit evenly like polygons, not black.
    appearance.Ambient += appearance.Diffuse;
  }
  return true;
}

}
