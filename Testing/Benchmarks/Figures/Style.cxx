// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Style.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVolumeProperty.h>

#include <cstddef>

namespace Style
{
namespace
{

void AddLight(
  vtkRenderer* renderer, const std::array<double, 3>& from, const Color& color, double intensity)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(from.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetDiffuseColor(color.data());
  light->SetSpecularColor(color.data());
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

}

void PointCamera(vtkRenderer* renderer, const double bounds[6], const View& view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(view.From.data());
  camera->SetViewUp(view.Up.data());
  renderer->ResetCamera(bounds);
  camera->Zoom(view.Zoom);
  renderer->ResetCameraClippingRange(bounds);
}

void AddLights(vtkRenderer* renderer)
{
  AddLight(renderer, { -0.6, 0.7, 1.0 }, { 1.0, 0.98, 0.94 }, 0.85);
  AddLight(renderer, { 1.0, 0.1, 0.5 }, { 0.75, 0.85, 1.0 }, 0.25);
  AddLight(renderer, { 0.0, 0.0, 1.0 }, { 1.0, 1.0, 1.0 }, 0.15);
}

void Show(vtkVolumeProperty* property, const std::vector<Surface>& surfaces)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkContourValues* isovalues = property->GetIsoSurfaceValues();
  isovalues->SetNumberOfContours(static_cast<int>(surfaces.size()));
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    const Surface& surface = surfaces[i];
    isovalues->SetValue(static_cast<int>(i), surface.Isovalue);
    color->AddRGBPoint(surface.Isovalue, surface.Color[0], surface.Color[1], surface.Color[2]);
    opacity->AddPoint(surface.Isovalue, surface.Opacity);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.15);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.25);
  property->SetSpecularPower(25.0);
}

}
