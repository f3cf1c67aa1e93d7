// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureScene.h"

#include "Measuring.h"

#include <vtkCamera.h>
#include <vtkPlane.h>
#include <vtkVolumeProperty.h>

FeatureScene::FeatureScene(const GallerySettings& settings, const Subject& subject)
  : FeatureScene(settings, subject.Image, subject.Name, subject.View)
{
}

FeatureScene::FeatureScene(const GallerySettings& settings, vtkDataObject* data,
  const std::string& name, const Style::View& view)
  : Room(settings.Size)
  , Settings(settings)
{
  this->Volume->SetMapper(this->Mapper);
  this->Room.Renderer->AddVolume(this->Volume);
  this->SetInput(data, name, view);
}

void FeatureScene::SetInput(vtkDataObject* data, const std::string& name, const Style::View& view)
{
  this->Mapper->SetInputDataObject(data);
  this->Shown = name;
  Style::PointCamera(this->Room.Renderer, this->Volume->GetBounds(), view);
}

void FeatureScene::Show(const std::vector<Style::Surface>& surfaces)
{
  Style::Show(this->Volume->GetProperty(), surfaces);
}

void FeatureScene::Clip(const std::array<double, 3>& normal, double share)
{
  const double* bounds = this->Volume->GetBounds();
  double origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = bounds[2 * axis] + share * (bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin);
  plane->SetNormal(normal.data());
  this->Mapper->AddClippingPlane(plane);
}

void FeatureScene::CropCorner()
{
  const double* bounds = this->Volume->GetBounds();
  const double* position = this->Room.Renderer->GetActiveCamera()->GetPosition();
  double planes[6];
  int region = 0, stride = 1;
  for (int axis = 0; axis < 3; ++axis, stride *= 3)
  {
    // The corner begins in the middle; the other plane is the box's own.
    const double low = bounds[2 * axis], high = bounds[2 * axis + 1];
    const bool isHigh = position[axis] > 0.5 * (low + high);
    planes[2 * axis] = isHigh ? low : 0.5 * (low + high);
    planes[2 * axis + 1] = isHigh ? 0.5 * (low + high) : high;
    region += stride * (isHigh ? 2 : 0);
  }
  constexpr int all = (1 << 27) - 1;
  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(planes);
  this->Mapper->SetCroppingRegionFlags(all & ~(1 << region));
}

Shot FeatureScene::Take(const std::string& name, const std::string& title, const std::string& how)
{
  Shot shot = { name, title, how, this->Shown, this->Room.PhotographFinal(), 0.0 };
  std::vector<double> times;
  for (int frame = 0; frame < this->Settings.Frames; ++frame)
  {
    this->Room.Renderer->GetActiveCamera()->Azimuth(Degrees);
    this->Room.Photograph();
    times.push_back(1e3 * this->Mapper->GetStatistics()->GetFrameTime());
  }
  shot.Ms = Measuring::Median(times);
  return shot;
}
