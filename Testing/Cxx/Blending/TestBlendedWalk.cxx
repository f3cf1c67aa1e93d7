// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Blended volumes on random walks: each frame is that of a mapper without a past.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "Walks/BlendChanges.h"
#include "Walks/FeatureChanges.h"
#include "Walks/RandomChanges.h"

#include <cstdlib>

namespace
{

Sweep::Routes Walk(unsigned seed, const Twelfths& often, int steps)
{
  const vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  RandomViews views(scene, seed, 60);
  std::vector<KindOfChange> kinds = KindsOfChange(scene, image, views, often);
  kinds.push_back({ 2, BlendChanges::OfMode(scene, views) });
  kinds.push_back({ 4, BlendChanges::OfLook(scene, views) });
  kinds.push_back({ 1, FeatureChanges::OfRegion(scene, views) });
  kinds.push_back({ 1, FeatureChanges::OfOpacity(scene, views) });
  kinds.push_back({ 2, FeatureChanges::OfAppearance(scene, views) });
  BlendChanges::OfMode(scene, views).front().Make();
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
  Walk(23, steps, 100);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
