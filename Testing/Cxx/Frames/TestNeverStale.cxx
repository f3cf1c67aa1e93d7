// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever changes, in whatever order, no picture shows what was true before.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomChanges.h"
#include "Walks/Sweep.h"

#include <cstdlib>

namespace
{

/// Changes in random order, up to five at a time.
/// \return how often each route was taken
Sweep::Routes Wander(unsigned seed, const Twelfths& often, int steps)
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 0.0 });
  scene.Mapper->SetReuseAccuracyToPaper();
  RandomViews views(scene, seed, 80);
  // Limits of memory are reached on purpose.
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  return Wander(
    scene, views, KindsOfChange(scene, image, views, often), "seed " + std::to_string(seed), steps);
}

void ExpectAtLeast(
  int count, const char* route, const Sweep::Routes& routes, const std::string& what)
{
  const auto found = routes.find(route);
  const int taken = found == routes.end() ? 0 : found->second;
  Expect(
    taken >= count, what + ": only " + std::to_string(taken) + " frames of the route " + route);
}

}

int TestNeverStale(int, char*[])
{
  Twelfths movingOn;
  movingOn.View = 12;
  movingOn.Scene = 4;
  movingOn.Isovalues = 0;
  movingOn.ImageCache = 3;
  movingOn.Isomap = 0;
  for (const unsigned seed : { 7u, 8u })
  {
    const std::string what = "moving on, seed " + std::to_string(seed);
    const Sweep::Routes routes = Wander(seed, movingOn, 500);
    ExpectAtLeast(50, "ImageCache", routes, what);
  }
  Twelfths standingStill;
  standingStill.View = 3;
  standingStill.Isovalues = 9;
  standingStill.Isomap = 3;
  for (const unsigned seed : { 9u, 10u, 11u, 12u })
  {
    const std::string what = "standing still, seed " + std::to_string(seed);
    const Sweep::Routes routes = Wander(seed, standingStill, 1000);
    ExpectAtLeast(100, "IsomapBuild", routes, what);
    ExpectAtLeast(20, "IsomapLookup", routes, what);
    ExpectAtLeast(3, "ImageCache", routes, what);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
