// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Isovalue.h"
#include "Options.h"
#include "VolumeReader.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <cmath>

namespace
{

// Slightly from above: more of the shape is seen than in a level view.
constexpr double ElevationDegrees = 6.0;

// ResetCamera fits the sphere around the volume's box; few objects fill its corners.
constexpr double ZoomBeyondFit = 1.25;

std::array<double, 3> AxisVector(const std::string& axis)
{
  std::array<double, 3> vector = { 0.0, 0.0, 0.0 };
  vector[static_cast<std::size_t>(axis[1] - 'x')] = axis[0] == '-' ? -1.0 : 1.0;
  return vector;
}

// From the upper left behind the viewer, so that shapes show; and weakly from the viewer.
void AddLights(vtkRenderer* renderer)
{
  vtkNew<vtkLight> key;
  key->SetLightTypeToCameraLight();
  key->SetPosition(-0.5, 0.6, 1.0);
  key->SetFocalPoint(0.0, 0.0, 0.0);
  key->SetIntensity(0.9);
  renderer->AddLight(key);

  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.25);
  renderer->AddLight(fill);
}

void SetUpShading(vtkVolumeProperty* property)
{
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.15);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.25);
  property->SetSpecularPower(20.0);
}

}

Scene::Scene(const Volume& source, const IsovalueChoice& isovalue, const Options& options)
{
  this->Mapper->SetInputData(source.Image);
  if (options.ThresholdMode)
  {
    this->Mapper->SetSurfaceModeToThreshold();
  }

  this->Actor->SetMapper(this->Mapper);
  if (source.Placement)
  {
    this->Actor->SetUserMatrix(source.Placement);
  }
  vtkVolumeProperty* property = this->Actor->GetProperty();
  SetUpShading(property);
  vtkNew<vtkPiecewiseFunction> opaque;
  opaque->AddPoint(isovalue.Range[0], 1.0);
  opaque->AddPoint(isovalue.Range[1], 1.0);
  property->SetScalarOpacity(opaque);
  const double width = isovalue.Range[1] - isovalue.Range[0];
  this->ColorValues = { isovalue.Value - 0.1 * width, isovalue.Value,
    isovalue.Value + 0.3 * width };
  this->SetDefaultColor();
  this->SetIsovalue(isovalue.Value);

  this->Renderer->AddVolume(this->Actor);
  AddLights(this->Renderer);
  this->Up = AxisVector(options.Up);
  std::string from = options.From.empty() ? source.From : options.From;
  if (from[1] == options.Up[1])
  {
    from = "+z";
  }
  this->From = AxisVector(from);

  this->Renderer->ResetCamera(this->Actor->GetBounds());
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->GetFocalPoint(this->Middle.data());
  this->Distance = camera->GetDistance();
  camera->Zoom(ZoomBeyondFit);
  this->SetAzimuth(0.0);
}

void Scene::SetIsovalue(double isovalue)
{
  this->Actor->GetProperty()->GetIsoSurfaceValues()->SetValue(0, isovalue);
}

void Scene::SetLowColor(double red, double green, double blue)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(this->ColorValues[0], red, green, blue);
  colors->AddRGBPoint(
    this->ColorValues[1], 0.5 * (red + 1.0), 0.5 * (green + 0.95), 0.5 * (blue + 0.85));
  colors->AddRGBPoint(this->ColorValues[2], 0.98, 0.95, 0.88);
  this->Actor->GetProperty()->SetColor(colors);
}

void Scene::SetAzimuth(double degrees)
{
  const double azimuth = vtkMath::RadiansFromDegrees(degrees);
  const double elevation = vtkMath::RadiansFromDegrees(ElevationDegrees);
  double side[3];
  vtkMath::Cross(this->Up.data(), this->From.data(), side);
  double position[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double level = std::cos(azimuth) * this->From[axis] + std::sin(azimuth) * side[axis];
    position[axis] = this->Middle[axis] +
      this->Distance * (std::cos(elevation) * level + std::sin(elevation) * this->Up[axis]);
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(position);
  camera->SetFocalPoint(this->Middle.data());
  camera->SetViewUp(this->Up.data());
  this->Renderer->ResetCameraClippingRange(this->Actor->GetBounds());
}
