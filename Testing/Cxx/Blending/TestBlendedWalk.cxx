// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// On random walks, each frame of a blended volume is that of a mapper without a past.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "Walks/BlendChanges.h"
#include "Walks/FeatureChanges.h"
#include "Walks/RandomChanges.h"

#include <cstdlib>

namespace
{

/// The modes that are drawn with either interpolation, and isosurfaces.
std::vector<int> DrawnModes(vtkImageData* image)
{
  std::vector<int> modes{ vtkVolumeMapper::ISOSURFACE_BLEND };
  for (const int mode : { vtkVolumeMapper::COMPOSITE_BLEND,
         vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    bool isDrawn = true;
    for (const int interpolation : { VTK_LINEAR_INTERPOLATION, VTK_NEAREST_INTERPOLATION })
    {
      Scene scene(image, {});
      const EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
      scene.Mapper->SetBlendMode(mode);
      scene.Volume->GetProperty()->SetInterpolationType(interpolation);
      isDrawn = scene.Render(16, 16) && isDrawn;
    }
    modes.insert(modes.end(), isDrawn ? 1 : 0, mode);
  }
  return modes;
}

Sweep::Routes Walk(unsigned seed, const Twelfths& often, int steps)
{
  const vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  RandomViews views(scene, seed, 60);
  std::vector<KindOfChange> kinds = KindsOfChange(scene, image, views, often);
  kinds.push_back({ 2, BlendChanges::OfMode(scene, views, DrawnModes(image)) });
  kinds.push_back({ 4, BlendChanges::OfLook(scene, views) });
  // A region may change and keep what it kept: then the picture is shown again.
  std::vector<Change> ofRegion = FeatureChanges::OfRegion(scene, views);
  for (Change& change : ofRegion)
  {
    change.IsOfData = false;
  }
  kinds.push_back({ 1, ofRegion });
  kinds.push_back({ 1, FeatureChanges::OfOpacity(scene, views) });
  kinds.push_back({ 2, FeatureChanges::OfAppearance(scene, views) });
  scene.Mapper->SetBlendModeToMaximumIntensity();
  return Wander(scene, views, kinds, "seed " + std::to_string(seed), steps);
}

}

int TestBlendedWalk(int, char*[])
{
  Twelfths moving;
  moving.Isovalues = 0;
  Walk(21, moving, 150);
  Twelfths still;
  still.View = 1;
  still.Isovalues = 2;
  Walk(22, still, 150);
  Twelfths steps;
  steps.View = 1;
  steps.Scene = 9;
  Sweep::Routes routes = Walk(23, steps, 100);
  Expect(routes["KeepValues"] > 3, "what rays of projections have met is kept");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
