// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/VolumeView.h"

#include "Drawing/Theme.h"
#include "Files/Arrays.h"
#include "Model/Appearance.h"
#include "Program/UserError.h"
#include "View/Picture.h"
#include "View/Viewpoint.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr std::array<double, 3> Background = { Theme::View.Red, Theme::View.Green,
  Theme::View.Blue };
constexpr double ShareFilled = 0.85; // of the view, by the volume's box
constexpr double BytesPerMiB = 1024.0 * 1024.0;

struct Build
{
  vtkTemporalCoherenceVolumeMapper* Mapper;
  const std::function<bool(double)>& Progress;
  bool IsStopped = false;

  static void OnProgress(vtkObject*, unsigned long, void* clientData, void* callData)
  {
    auto* self = static_cast<Build*>(clientData);
    self->IsStopped = self->IsStopped || !self->Progress(*static_cast<double*>(callData));
    if (self->IsStopped)
    {
      self->Mapper->SetAbortExecute(1);
    }
  }
};

}

VolumeView::VolumeView()
{
  // The histogram beside the view shows where the isovalue lies in the range.
  this->Mapper->WarnOfIsovaluesOff();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->SetInterpolationTypeToLinear();
  this->Renderer->SetBackground(
    Background[0] / 255.0, Background[1] / 255.0, Background[2] / 255.0);
}

void VolumeView::Show(const Volume& volume, const std::array<double, 2>& range)
{
  this->Range = range;
  this->Mapper->ReleaseReuse();
  this->Mapper->SetInputDataObject(volume.Data);
  ShowArray(volume, this->Mapper);
  this->Actor->SetUserMatrix(volume.Placement);
  vtkNew<vtkPiecewiseFunction> opaque;
  opaque->AddPoint(range[0], 1.0);
  opaque->AddPoint(range[1], 1.0);
  this->Actor->GetProperty()->SetScalarOpacity(opaque);
  if (!this->Renderer->HasViewProp(this->Actor))
  {
    this->Renderer->AddVolume(this->Actor);
  }
}

void VolumeView::SetIsovalue(double isovalue)
{
  this->Actor->GetProperty()->GetIsoSurfaceValues()->SetValue(0, isovalue);
}

void VolumeView::Apply(const Chosen& choices)
{
  vtkVolumeProperty* property = this->Actor->GetProperty();
  SetPalette(property->GetRGBTransferFunction(), choices[Choose::Palette], this->Range);
  SetMaterial(property, choices[Choose::Material]);
  SetLight(this->Renderer, choices[Choose::Light]);
  this->Mapper->SetSurfaceMode(choices[Choose::Surface]);
  this->Mapper->SetAveragedGradients(choices.IsOn(Choose::Gradients));
  this->Mapper->SetReuseAccuracy(choices[Choose::Accuracy]);
  this->Mapper->SetImageCache(choices.IsOn(Choose::ImageCache));
  this->Mapper->SetIsomap(choices.IsOn(Choose::Isomap));
  this->Mapper->SetSpaceLeaping(choices.IsOn(Choose::Leaping));
  this->Mapper->SetColorByAnswer(choices.IsOn(Choose::Answers));
  // A completed picture owes nothing to the cache: it would have no yellow.
  this->Mapper->SetRefineWhenStill(!choices.IsOn(Choose::Answers));
}

void VolumeView::LookFrom(const std::string& from, const std::string& up)
{
  const double* bounds = this->Actor->GetBounds();
  Viewpoint(this->Renderer, bounds, from, up).PlaceCamera(this->Renderer, 0.0);
  // As large as it can be as it lies there; a little smaller, so that it may be turned.
  double widest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double x = bounds[corner & 1], y = bounds[2 + ((corner >> 1) & 1)],
           z = bounds[4 + ((corner >> 2) & 1)];
    this->Renderer->WorldToView(x, y, z);
    widest = std::max({ widest, std::abs(x), std::abs(y) });
  }
  this->Renderer->GetActiveCamera()->Zoom(std::clamp(ShareFilled / widest, 0.3, 3.0));
}

CameraState VolumeView::Camera() const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  CameraState state;
  camera->GetPosition(state.Position.data());
  camera->GetFocalPoint(state.FocalPoint.data());
  camera->GetViewUp(state.ViewUp.data());
  state.ViewAngle = camera->GetViewAngle();
  return state;
}

void VolumeView::SetCamera(const CameraState& state)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(state.Position.data());
  camera->SetFocalPoint(state.FocalPoint.data());
  camera->SetViewUp(state.ViewUp.data());
  camera->SetViewAngle(state.ViewAngle);
  this->Renderer->ResetCameraClippingRange();
}

bool VolumeView::BuildIsomap(const std::function<bool(double share)>& progress)
{
  Build build{ this->Mapper, progress };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&build);
  command->SetCallback(&Build::OnProgress);
  this->Mapper->AddObserver(vtkCommand::ProgressEvent, command);
  this->Mapper->SetIsomapRange(this->Range.data());
  const bool isBuilt = this->Mapper->BuildIsomap(this->Renderer, this->Actor);
  // Views that follow begin with narrow bands again.
  this->Mapper->SetIsomapRange(1.0, 0.0);
  this->Mapper->RemoveObserver(command);
  return isBuilt;
}

vtkSmartPointer<vtkImageData> VolumeView::Picture(int scale)
{
  if (scale == 1)
  {
    return this->LastFrame();
  }
  const int* size = this->Renderer->GetSize();
  vtkNew<vtkImageData> picture;
  this->Renderer->ResetCameraClippingRange();
  if (!this->Mapper->RenderToImage(
        this->Renderer, this->Actor, scale * size[0], scale * size[1], picture, nullptr))
  {
    throw UserError("The picture could not be made; choose a smaller picture scale.");
  }
  return OnBackground(picture, Background, Background);
}

vtkSmartPointer<vtkImageData> VolumeView::LastFrame()
{
  vtkNew<vtkImageData> picture;
  if (!this->Mapper->GetLastFrame(picture, vtkTemporalCoherenceVolumeMapper::FRAME_COLOR))
  {
    throw UserError("There is no picture yet; open a volume first.");
  }
  return OnBackground(picture, Background, Background);
}

FrameFacts VolumeView::Facts()
{
  FrameFacts facts;
  facts.Route = this->Mapper->GetRouteAsString();
  facts.Ms = 1000.0 * this->Mapper->GetFrameTime();
  const double rays = std::max(1.0, static_cast<double>(this->Mapper->GetNumberOfRays()));
  const auto share = [rays](vtkIdType count) { return static_cast<double>(count) / rays; };
  facts.Misses = share(this->Mapper->GetNumberOfDefiniteMisses());
  facts.Hits = share(this->Mapper->GetNumberOfDefiniteHits());
  facts.PossibleHits = share(this->Mapper->GetNumberOfPossibleHits());
  facts.Traced = share(this->Mapper->GetNumberOfTracedRays());
  facts.SamplesPerRay = share(this->Mapper->GetNumberOfFieldSamples());
  facts.IsomapMiB = static_cast<double>(this->Mapper->GetIsomapMemory()) / BytesPerMiB;
  return facts;
}

vtkColorTransferFunction* VolumeView::Colors() const
{
  return this->Actor->GetProperty()->GetRGBTransferFunction();
}
