// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever changes, in whatever order: no picture ever shows what was true before.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomChanges.h"
#include "Walks/Sweep.h"

#include <cstdlib>
#include <utility>

namespace
{

/// How many of twelve steps make a change of each kind.
struct Habits
{
  int View, Scene, Isovalues, ImageCache, Isomap;
};

/// Changes in random order, up to five at a time.
/// \return how often each route was taken
Sweep::Routes Wander(unsigned seed, const Habits& habits, int steps)
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 0.0 });
  RandomViews views(scene, seed, 80);
  // Limits of memory are reached on purpose.
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  const std::vector<KindOfChange> kinds = {
    { habits.View, ChangesOfView(scene, views) },
    { habits.Scene, ChangesOfScene(scene, image, views) },
    { habits.Isovalues, ChangesOfIsovalues(scene, views) },
    { habits.ImageCache, ChangesOfImageCache(scene, views) },
    { habits.Isomap, ChangesOfIsomap(scene, views) },
  };
  return Wander(scene, views, kinds, "seed " + std::to_string(seed), steps);
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
  for (const unsigned seed : { 7u, 8u })
  {
    const std::string what = "moving on, seed " + std::to_string(seed);
    const Sweep::Routes routes = Wander(seed, { 12, 4, 0, 3, 0 }, 500);
    ExpectAtLeast(100, "ImageCache", routes, what);
  }
  for (const unsigned seed : { 9u, 10u, 11u, 12u })
  {
    const std::string what = "standing still, seed " + std::to_string(seed);
    const Sweep::Routes routes = Wander(seed, { 3, 1, 9, 1, 1 }, 1000);
    ExpectAtLeast(100, "IsomapBuild", routes, what);
    ExpectAtLeast(20, "IsomapLookup", routes, what);
    ExpectAtLeast(10, "ThresholdHint", routes, what);
    ExpectAtLeast(20, "ImageCache", routes, what);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
