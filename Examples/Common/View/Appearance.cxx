// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/Appearance.h"

#include "View/Light.h"

#include <vtkColorTransferFunction.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkVolumeProperty.h>

#include <cstddef>

namespace
{

struct Stop
{
  double Share; // of the range of values
  double Red, Green, Blue;
};

struct Palette
{
  const char* Name;
  std::vector<Stop> Stops;
};

const std::vector<Palette>& Palettes()
{
  static const std::vector<Palette> palettes = {
    { "tissue",
      { { 0.0, 0.72, 0.42, 0.32 }, { 0.3, 0.88, 0.68, 0.52 }, { 0.6, 0.97, 0.93, 0.85 } } },
    { "ivory", { { 0.0, 0.94, 0.90, 0.82 } } },
    { "steel", { { 0.0, 0.40, 0.50, 0.62 }, { 1.0, 0.86, 0.91, 0.96 } } },
    { "ember",
      { { 0.0, 0.42, 0.08, 0.12 }, { 0.35, 0.85, 0.30, 0.12 }, { 0.7, 0.98, 0.72, 0.30 },
        { 1.0, 1.00, 0.96, 0.80 } } },
    { "viridis",
      { { 0.0, 0.27, 0.00, 0.33 }, { 0.25, 0.23, 0.32, 0.55 }, { 0.5, 0.13, 0.57, 0.55 },
        { 0.75, 0.37, 0.79, 0.38 }, { 1.0, 0.99, 0.91, 0.14 } } },
    { "cool-warm",
      { { 0.0, 0.33, 0.45, 0.85 }, { 0.5, 0.87, 0.87, 0.87 }, { 1.0, 0.80, 0.26, 0.22 } } },
  };
  return palettes;
}

void AddCameraLight(vtkRenderer* renderer, double x, double y, double z, double intensity)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

void AddHeadlight(vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  renderer->AddLight(light);
}

void SetShading(
  vtkVolumeProperty* property, double ambient, double diffuse, double specular, double power)
{
  property->ShadeOn();
  property->SetAmbient(ambient);
  property->SetDiffuse(diffuse);
  property->SetSpecular(specular);
  property->SetSpecularPower(power);
}

}

std::vector<const char*> PaletteNames()
{
  std::vector<const char*> names;
  for (const Palette& palette : Palettes())
  {
    names.push_back(palette.Name);
  }
  return names;
}

std::vector<const char*> MaterialNames()
{
  return { "satin", "matt", "glossy", "flat" };
}

std::vector<const char*> LightNames()
{
  return { "studio", "head", "side", "rim" };
}

void SetPalette(vtkColorTransferFunction* colors, int palette, const std::array<double, 2>& range)
{
  colors->RemoveAllPoints();
  for (const Stop& stop : Palettes()[static_cast<std::size_t>(palette)].Stops)
  {
    colors->AddRGBPoint(
      range[0] + stop.Share * (range[1] - range[0]), stop.Red, stop.Green, stop.Blue);
  }
}

void SetMaterial(vtkVolumeProperty* property, int material)
{
  switch (material)
  {
    case 1:
      SetShading(property, 0.15, 0.85, 0.0, 1.0);
      break;
    case 2:
      SetShading(property, 0.12, 0.7, 0.6, 60.0);
      break;
    case 3:
      property->ShadeOff();
      break;
    default:
      SetSatinShading(property);
  }
}

void SetLight(vtkRenderer* renderer, int light)
{
  renderer->RemoveAllLights();
  switch (light)
  {
    case 1:
      AddHeadlight(renderer);
      break;
    case 2:
      AddCameraLight(renderer, -1.0, 0.1, 0.25, 1.0);
      AddCameraLight(renderer, 1.0, 0.0, 0.6, 0.15);
      break;
    case 3:
      AddCameraLight(renderer, -0.9, 0.5, -0.35, 1.0);
      AddCameraLight(renderer, 0.9, 0.5, -0.35, 1.0);
      AddCameraLight(renderer, 0.0, 0.2, 1.0, 0.3);
      break;
    default:
      AddStudioLights(renderer);
  }
}
