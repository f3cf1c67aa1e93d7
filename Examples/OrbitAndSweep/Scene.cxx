// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Files/Arrays.h"
#include "Options.h"
#include "View/Isovalue.h"
#include "View/Light.h"

#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

Scene::Scene(const Volume& source, const IsovalueChoice& isovalue, const Options& options)
{
  this->Mapper->SetInputDataObject(source.Data);
  this->Mapper->SmoothMeshNormalsOn(); // smooth normals of meshes
  ShowArray(source, this->Mapper);
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
  property->SetInterpolationTypeToLinear();
  SetSatinShading(property);
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
  AddStudioLights(this->Renderer);
  this->Around = Viewpoint(this->Renderer, this->Actor->GetBounds(),
    options.From.empty() ? source.From : options.From, options.Up);
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
  this->Around.PlaceCamera(this->Renderer, degrees);
}
