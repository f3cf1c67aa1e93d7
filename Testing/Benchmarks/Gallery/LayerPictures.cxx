// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerPictures.h"

#include <vtkVolumeProperty.h>

namespace LayerPictures
{
namespace
{

/// Put a volume into the middle of another, so large that it takes a share of the other's height.
void PutInside(vtkVolume* volume, vtkVolume* other, double share)
{
  const double* outer = other->GetBounds();
  const double* inner = volume->GetBounds();
  const double scale = share * (outer[5] - outer[4]) / (inner[5] - inner[4]);
  double place[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    place[axis] = 0.5 *
      (outer[2 * axis] + outer[2 * axis + 1] - scale * (inner[2 * axis] + inner[2 * axis + 1]));
  }
  volume->SetScale(scale);
  volume->SetPosition(place);
}

}

Shot Skull(GallerySettings& settings)
{
  const Subject subject = FirstOf({ { "cthead.vti", "CT head 256x256x113", { 600.0, 1500.0 },
                                      { { -0.6, -1.0, 0.1 }, { 0.0, 0.0, -1.0 }, 1.45 } },
                                    MrHead({ 45.0, 110.0 }), SpheresInstead({ 100.0, 180.0 }) },
    settings);
  FeatureScene scene(settings, subject);
  scene.Show(
    { { subject.Isovalues[0], Style::Skin, 0.35 }, { subject.Isovalues[1], Style::Bone } });
  return scene.Take("translucent", "Skin over bone",
    "isovalues " + Plain(subject.Isovalues[0]) + " and " + Plain(subject.Isovalues[1]) +
      "; colours and opacities (0.35, 1) of the property's transfer functions");
}

Shot Flames(GallerySettings& settings)
{
  const Subject subject = FirstOf({ { "heptane.vti", "simulated fire 302^3", { 20.0, 60.0, 120.0 },
                                      { { 0.4, -1.6, 0.7 }, { -1.0, 0.0, 0.0 }, 1.7 } },
                                    SpheresInstead({ 60.0, 120.0, 180.0 }) },
    settings);
  FeatureScene scene(settings, subject);
  scene.Show({ { subject.Isovalues[0], Style::Steel, 0.15 },
    { subject.Isovalues[1], Style::Gold, 0.35 }, { subject.Isovalues[2], Style::Coral, 0.8 } });
  return scene.Take(
    "flames", "Sheets of fire", "three isovalues within each other, opacities 0.15, 0.35 and 0.8");
}

Shot Vessels(GallerySettings& settings)
{
  const Subject brain = FirstOf({ { "ch2bet.nii.gz", "MR brain 181x217x181", { 60.0 },
                                    { { -1.0, 0.5, 0.25 }, { 0.0, 0.0, 1.0 }, 1.6 } },
                                  SpheresInstead({ 60.0 }) },
    settings);
  const Subject vessels = FirstOf(
    { { "aneurism.vti", "vessels 256^3", { 60.0 }, {} }, SpheresInstead({ 180.0 }) }, settings);
  FeatureScene scene(settings, brain);
  scene.Show({ { brain.Isovalues[0], Style::Bone, 0.15 } });
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  vtkNew<vtkTemporalCoherenceVolume> volume;
  mapper->SetInputDataObject(vessels.Image);
  volume->SetMapper(mapper);
  Style::Show(volume->GetProperty(), { { vessels.Isovalues[0], Style::Coral } });
  PutInside(volume, scene.Volume, 0.5);
  scene.Room.Renderer->AddVolume(volume);
  return scene.Take("vessels", "Vessels in a brain",
    "two volumes, of which the inner one (" + vessels.Name +
      ", of another patient) is opaque: each layer of the brain is in front of it or hidden by it. "
      "The time is the brain's");
}

}
