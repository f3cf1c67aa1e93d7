// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/Scene.h"

#include <vtkContourValues.h>
#include <vtkMath.h>

#include <cmath>

Scene::Scene(vtkDataSet* data, const std::vector<double>& isovalues)
{
  this->Mapper->SetInputDataObject(data);
  this->Mapper->SetAntialiasingToOff(); // tests compare single rays
  this->Volume->SetMapper(this->Mapper);
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.9, 0.8, 0.7);
  property->SetColor(color);
  this->SetIsovalues(isovalues);
  this->Renderer->AddVolume(this->Volume);
}

void Scene::SetIsovalues(const std::vector<double>& isovalues)
{
  vtkContourValues* list = this->Volume->GetProperty()->GetIsoSurfaceValues();
  list->SetNumberOfContours(static_cast<int>(isovalues.size()));
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    list->SetValue(static_cast<int>(i), isovalues[i]);
  }
}

void Scene::LookFrom(double x, double y, double z)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(x, y, z);
  const bool isVertical = std::abs(z) > 0.9 * std::hypot(x, y, z);
  camera->SetViewUp(0.0, isVertical ? 1.0 : 0.0, isVertical ? 0.0 : 1.0);
  this->Renderer->ResetCamera();
}

bool Scene::Render(int width, int height)
{
  return this->Mapper->MakeImage(
    this->Renderer, this->Volume, width, height, this->Color, this->Depth);
}

bool Scene::GetLastFrame(vtkImageData* color, vtkImageData* depth)
{
  return this->Mapper->GetLastFrame(color, vtkTemporalCoherenceVolumeMapper::FRAME_COLOR) &&
    this->Mapper->GetLastFrame(depth, vtkTemporalCoherenceVolumeMapper::FRAME_DEPTH);
}
