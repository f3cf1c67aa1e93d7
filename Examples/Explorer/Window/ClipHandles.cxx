// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ClipHandles.h"

#include <vtkCommand.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTransform.h>

ClipHandles::ClipHandles(
  Workbench& bench, vtkRenderWindowInteractor* interactor, double pixels, QObject* parent)
  : QObject(parent)
  , Bench(bench)
{
  this->PlaneWidget->SetRepresentation(this->PlaneShape);
  this->PlaneShape->SetPlaceFactor(1.0);
  this->PlaneShape->GetPlaneProperty()->SetOpacity(0.15);
  for (vtkProperty* lines : { this->PlaneShape->GetNormalProperty(),
         this->PlaneShape->GetSelectedNormalProperty(), this->PlaneShape->GetEdgesProperty(),
         this->BoxShape->GetOutlineProperty(), this->BoxShape->GetSelectedOutlineProperty() })
  {
    lines->SetLineWidth(static_cast<float>(pixels));
  }
  this->PlaneShape->SetHandleSize(pixels * this->PlaneShape->GetHandleSize());
  this->BoxShape->SetHandleSize(pixels * this->BoxShape->GetHandleSize());
  this->PlaneShape->GetSelectedPlaneProperty()->SetOpacity(0.25);
  this->PlaneShape->DrawOutlineOff();
  this->PlaneShape->ScaleEnabledOff();
  this->BoxWidget->SetRepresentation(this->BoxShape);
  this->BoxWidget->RotationEnabledOff();
  this->BoxShape->SetPlaceFactor(1.0);
  this->BoxShape->HandlesOn();
  for (vtkAbstractWidget* widget : { static_cast<vtkAbstractWidget*>(this->PlaneWidget),
         static_cast<vtkAbstractWidget*>(this->BoxWidget) })
  {
    widget->SetInteractor(interactor);
    widget->SetCurrentRenderer(bench.Data.View.Renderer);
    widget->KeyPressActivationOff();
    widget->AddObserver(vtkCommand::StartInteractionEvent, &bench, &Workbench::BeginGesture);
  }
  this->PlaneWidget->AddObserver(vtkCommand::InteractionEvent, this, &ClipHandles::TakePlane);
  this->BoxWidget->AddObserver(vtkCommand::InteractionEvent, this, &ClipHandles::TakeBox);
  QObject::connect(&bench, &Workbench::Opened, this, &ClipHandles::Place);
  QObject::connect(&bench, &Workbench::Changed, this, &ClipHandles::Show);
}

void ClipHandles::Place()
{
  auto box = this->Bench.Data.View.DataBounds();
  this->BoxShape->PlaceWidget(box.data());
  auto world = this->Bench.Data.View.WorldBounds();
  this->PlaneShape->PlaceWidget(world.data());
  this->Show();
}

void ClipHandles::Show()
{
  // While an isomap is built, nothing in the view may change.
  if (!this->Bench.Data.IsOpen() || this->Bench.IsBuilding())
  {
    return;
  }
  const Look& look = this->Bench.Data.Settings();
  if (look.Values[Row::Clipping] != 0)
  {
    Plane plane = look.Clip;
    this->PlaneShape->SetOrigin(plane.Origin.data());
    this->PlaneShape->SetNormal(plane.Normal.data());
  }
  this->PlaneWidget->SetEnabled(look.Values[Row::Clipping] != 0);
  if (look.Values[Row::Cropping] != 0)
  {
    // From the whole box to the part of it, and to where the data lie in the world.
    const double* crop = &look.Values[Row::Crop];
    const auto box = this->Bench.Data.View.DataBounds();
    vtkNew<vtkTransform> transform;
    transform->Concatenate(this->Bench.Data.View.Placement());
    transform->Translate(crop[0], crop[2], crop[4]);
    transform->Scale((crop[1] - crop[0]) / (box[1] - box[0]),
      (crop[3] - crop[2]) / (box[3] - box[2]), (crop[5] - crop[4]) / (box[5] - box[4]));
    transform->Translate(-box[0], -box[2], -box[4]);
    this->BoxShape->SetTransform(transform);
  }
  this->BoxWidget->SetEnabled(look.Values[Row::Cropping] != 0);
}

void ClipHandles::TakePlane()
{
  Plane plane;
  this->PlaneShape->GetOrigin(plane.Origin.data());
  this->PlaneShape->GetNormal(plane.Normal.data());
  this->Bench.Edit(tr("clipping"), [&](Look& look) { look.Clip = plane; });
}

void ClipHandles::TakeBox()
{
  vtkNew<vtkPolyData> points;
  this->BoxShape->GetPolyData(points);
  vtkNew<vtkMatrix4x4> toData;
  vtkMatrix4x4::Invert(this->Bench.Data.View.Placement(), toData);
  std::array<double, 6> crop;
  for (std::size_t side = 0; side < 6; ++side)
  {
    constexpr vtkIdType firstMiddle = 8; // of sides, after the corners
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    points->GetPoint(firstMiddle + static_cast<vtkIdType>(side), point);
    toData->MultiplyPoint(point, point);
    crop[side] = point[side / 2];
  }
  this->Bench.Edit(tr("cropping"),
    [&](Look& look) { std::copy(crop.begin(), crop.end(), &look.Values[Row::Crop]); });
}
