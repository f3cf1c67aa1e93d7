// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/ChangingScene.h"

#include "Walks/FeatureChanges.h"

#include <vtkContourValues.h>
#include <vtkPlaneCollection.h>

#include <array>

using Mapper = vtkTemporalCoherenceVolumeMapper;

ChangingScene::ChangingScene(unsigned seed, int size)
  : Views(Shown, seed, size)
  , Inputs(Shown, Views)
  , Warnings(Shown.Mapper, vtkCommand::WarningEvent)
  , Kinds({ ChangesOfView(Shown, Views), ChangesOfIsovalues(Shown, Views),
      FeatureChanges::OfAppearance(Shown, Views), FeatureChanges::OfLists(Shown, Views),
      FeatureChanges::OfOpacity(Shown, Views), FeatureChanges::OfRegion(Shown, Views),
      Inputs.Changes(), FeatureChanges::OfVolume(Shown, Views), ChangesOfImageCache(Shown, Views),
      ChangesOfIsomap(Shown, Views) })
{
}

void ChangingScene::MakeOneOf(std::size_t kind)
{
  std::vector<Change>& changes = this->Kinds[kind];
  changes[static_cast<std::size_t>(this->Views.Pick(static_cast<int>(changes.size())))].Make();
}

void ChangingScene::Arrange()
{
  FeatureChanges::SwitchOff(this->Shown);
  this->Inputs.Changes().back().Make(); // neither ghosts nor a mask
  this->Inputs.Show(static_cast<ManyInputs::Holder>(this->Views.Pick(3)),
    static_cast<ManyInputs::Scalars>(this->Views.Pick(5)));
  for (std::size_t kind = 2; kind < 8; ++kind)
  {
    for (int i = this->Views.Pick(4); i > 0; --i)
    {
      this->MakeOneOf(kind);
    }
  }
  this->Shown.Mapper->SetReuseAccuracy(Mapper::EXACT + this->Views.Pick(2));
  this->Shown.Mapper->SetIsomap(this->Views.Pick(3) != 0);
  this->Views.Resize();
}

void ChangingScene::ChangeSome(const Habits& habits)
{
  const std::array<int, 10> often = { habits.View, habits.Isovalues, habits.Appearance,
    habits.Lists, habits.Opacity, habits.Region, habits.Inputs, habits.Volume, habits.ImageCache,
    habits.Isomap };
  bool isSame = true;
  for (std::size_t kind = 0; kind < often.size(); ++kind)
  {
    if (this->Views.Pick(100) < often[kind])
    {
      this->MakeOneOf(kind);
      isSame = false;
    }
  }
  if (isSame && this->Views.Pick(4) != 0)
  {
    this->MakeOneOf(habits.View > 50 ? 0 : habits.Appearance > 50 ? 2 : 1);
  }
  if (this->Views.Pick(25) == 0)
  {
    // Another viewer, who has seen something else before.
    const vtkSmartPointer<vtkCamera> other = this->OtherCamera;
    this->OtherCamera = this->Shown.Renderer->GetActiveCamera();
    this->Shown.Renderer->SetActiveCamera(other);
    this->Shown.Renderer->ResetCameraClippingRange();
  }
}

std::set<std::string> ChangingScene::Features() const
{
  Mapper* mapper = this->Shown.Mapper;
  vtkVolumeProperty* property = this->Shown.Volume->GetProperty();
  std::set<std::string> features = { "all" };
  const auto add = [&](bool isOn, const char* name)
  {
    if (isOn)
    {
      features.insert(name);
    }
  };
  add(this->Inputs.In == ManyInputs::InGrid, "grid");
  add(this->Inputs.In == ManyInputs::InBlocks, "blocks");
  add(this->Inputs.Drawn == ManyInputs::OfCells, "cells");
  add(this->Inputs.Drawn == ManyInputs::Lengths, "lengths");
  add(this->Inputs.Drawn >= ManyInputs::Components, "components");
  add(this->Inputs.HidesCells(), "hidden");
  add(mapper->GetMaskInput() != nullptr, "masked");
  add(mapper->GetCropping(), "cropped");
  add(mapper->GetCropping() && mapper->GetCroppingRegionFlags() != VTK_CROP_SUBVOLUME, "in pieces");
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  add(planes && planes->GetNumberOfItems() > 0, "clipped");
  add(!mapper->IsOpaque(this->Shown.Volume), "translucent");
  add(property->HasGradientOpacity() && !property->GetDisableGradientOpacity(),
    "by gradient magnitude");
  add(mapper->GetColorArrayOpacity(), "opacity by an array");
  add(property->GetIsoSurfaceValues()->GetNumberOfContours() > 1, "several");
  add(property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION, "nearest");
  add(mapper->GetSurfaceMode() == Mapper::THRESHOLD, "threshold");
  add(!this->Shown.Renderer->GetTwoSidedLighting(), "one-sided");
  add(mapper->GetShadows() && property->GetShade(), "shadows");
  add(mapper->GetReuseAccuracy() == Mapper::EXACT, "exact");
  add(this->Shown.Renderer->GetActiveCamera()->GetParallelProjection(), "parallel");
  return features;
}
