// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "Checks/AreIdentical.h"
#include "Measuring.h"
#include "Scenes/ShiftCamera.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkMath.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

const std::vector<Framing>& AllFramings()
{
  static const std::vector<Framing> framings = {
    { "afar", "the whole volume, small: 5 to 35 % of the pixels hit", 0.0 },
    { "whole", "ResetCamera, Azimuth 30, Elevation 20, Zoom 1.3", 1.3 },
    { "close", "the same with Zoom 2.2: the object fills the picture", 2.2 }
  };
  return framings;
}

Stage::Stage(vtkDataSet* data, double isovalue, int size, const Framing& framing)
  : Size(size)
  , From(framing)
  , Data(data)
  , Image(vtkImageData::SafeDownCast(data))
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(isovalue, 0.9, 0.8, 0.7);
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetColor(color);
  property->ShadeOn();
  property->SetInterpolationTypeToLinear();
  property->GetIsoSurfaceValues()->SetValue(0, isovalue);
  this->ResetView();
}

void Stage::ResetView()
{
  const bool isAfar = this->From.Zoom == 0.0;
  vtkNew<vtkCamera> camera;
  if (isAfar)
  {
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(-1.0, -2.0, 0.8);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }
  this->Renderer->SetActiveCamera(camera);
  this->Renderer->ResetCamera(this->Data->GetBounds());
  if (!isAfar)
  {
    camera->Azimuth(30.0);
    camera->Elevation(20.0);
    camera->Zoom(this->From.Zoom);
    this->FitClippingRange();
  }
}

void Stage::FitClippingRange()
{
  this->Renderer->ResetCameraClippingRange(this->Data->GetBounds());
}

void Stage::Orbit(double degrees)
{
  this->Renderer->GetActiveCamera()->Azimuth(degrees);
  this->FitClippingRange();
}

void Stage::Approach(double factor)
{
  this->Renderer->GetActiveCamera()->Dolly(factor);
  this->FitClippingRange();
}

void Stage::Pan(double share)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
  ShiftCamera(camera, share * 2.0 * camera->GetDistance() * std::tan(0.5 * angle));
  this->FitClippingRange();
}

void Stage::SetIsovalue(double isovalue)
{
  this->Volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, isovalue);
}

double Stage::Isovalue() const
{
  return this->Volume->GetProperty()->GetIsoSurfaceValues()->GetValue(0);
}

double Stage::ShareOfRange(double share) const
{
  const double* range = this->Data->GetScalarRange();
  return share * (range[1] - range[0]);
}

double Stage::IsovalueAt(double share) const
{
  return this->Data->GetScalarRange()[0] + this->ShareOfRange(share);
}

double Stage::VoxelSize() const
{
  if (!this->Image)
  {
    const double* bounds = this->Data->GetBounds();
    const double volume =
      (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]);
    return std::cbrt(volume / static_cast<double>(this->Data->GetNumberOfCells()));
  }
  const double* spacing = this->Image->GetSpacing();
  return std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
}

Drawer::Drawer(const Stage& stage)
{
  this->Mapper->SetInputDataObject(stage.Data);
  this->Mapper->SetAntialiasingToOff();
}

double Drawer::Draw(const Stage& stage)
{
  bool isDrawn = false;
  const double begin = Measuring::CpuTime();
  const double time = Measuring::TimeOf(
    [&]
    {
      isDrawn = this->Mapper->MakeImage(
        stage.Renderer, stage.Volume, stage.Size, stage.Size, this->Color, this->Depth);
    });
  this->CpuMs = Measuring::CpuTime() - begin;
  if (!isDrawn)
  {
    throw Measuring::Failure("The volume cannot be drawn: mend what the mapper reports above.");
  }
  return time;
}

double Drawer::DrawCold(Stage& stage)
{
  // From a picture of nothing, nothing is known of the next one.
  vtkContourValues* isovalues = stage.Volume->GetProperty()->GetIsoSurfaceValues();
  const int count = isovalues->GetNumberOfContours();
  const std::vector<double> all(isovalues->GetValues(), isovalues->GetValues() + count);
  const vtkTypeBool isomap = this->Mapper->GetIsomap();
  this->Mapper->IsomapOff();
  isovalues->SetNumberOfContours(0);
  this->Draw(stage);
  isovalues->SetNumberOfContours(count);
  for (int i = 0; i < count; ++i)
  {
    isovalues->SetValue(i, all[static_cast<std::size_t>(i)]);
  }
  const double time = this->Draw(stage);
  this->Mapper->SetIsomap(isomap);
  if (this->Route() != "Cold")
  {
    throw Measuring::Failure(
      "A frame without isovalues is followed by " + this->Route() + ": mend Drawer::DrawCold.");
  }
  return time;
}

double PercentHit(const Drawer& drawer)
{
  const auto* depths = static_cast<const float*>(drawer.Depth->GetScalarPointer());
  const vtkIdType pixels = drawer.Depth->GetNumberOfPoints();
  const auto hits =
    std::count_if(depths, depths + pixels, [](float depth) { return std::isfinite(depth); });
  return 100.0 * static_cast<double>(hits) / static_cast<double>(pixels);
}

double PercentDifferent(const Drawer& a, const Drawer& b, const Stage& stage)
{
  const double voxel = stage.VoxelSize();
  const auto* first = static_cast<const float*>(a.Depth->GetScalarPointer());
  const auto* second = static_cast<const float*>(b.Depth->GetScalarPointer());
  const auto pixels = static_cast<std::size_t>(a.Depth->GetNumberOfPoints());
  std::size_t different = 0;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const bool isHit = std::isfinite(first[i]);
    const bool isFar = isHit && std::abs(static_cast<double>(first[i] - second[i])) > voxel;
    different += isHit != std::isfinite(second[i]) || isFar ? 1 : 0;
  }
  return 100.0 * static_cast<double>(different) / static_cast<double>(pixels);
}

double VoxelsApart(const Drawer& a, const Drawer& b, const Stage& stage)
{
  const auto* first = static_cast<const float*>(a.Depth->GetScalarPointer());
  const auto* second = static_cast<const float*>(b.Depth->GetScalarPointer());
  const auto pixels = static_cast<std::size_t>(a.Depth->GetNumberOfPoints());
  double farthest = 0.0;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (std::isfinite(first[i]) && std::isfinite(second[i]))
    {
      farthest = std::max(farthest, std::abs(static_cast<double>(first[i] - second[i])));
    }
  }
  return farthest / stage.VoxelSize();
}

bool AreIdentical(const Drawer& a, const Drawer& b)
{
  return AreIdentical(a.Color, b.Color) && AreIdentical(a.Depth, b.Depth);
}

vtkSmartPointer<vtkImageData> LoadOrTell(const std::string& name)
{
  vtkSmartPointer<vtkImageData> image = Volumes::Load(name);
  if (!image || image->GetNumberOfPoints() == 0)
  {
    const std::string folder = Volumes::DataDirectory();
    std::cerr << name << " is left out: it cannot be read; name the folder of volumes (now "
              << (folder.empty() ? "none" : folder)
              << ") in TEMPORAL_COHERENCE_DATA, and for ch2 install mricron-data.\n";
    return nullptr;
  }
  return image;
}
