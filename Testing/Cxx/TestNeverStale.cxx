// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever changes, in whatever order: no picture ever shows what was true before.

#include "EventCounter.h"
#include "Expect.h"
#include "RandomChanges.h"
#include "Sweep.h"
#include "Volumes.h"

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
  ColdWitness cold;
  // Limits of memory are reached on purpose.
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  const std::vector<std::pair<int, std::vector<Change>>> kinds = {
    { habits.View, ChangesOfView(scene, views) },
    { habits.Scene, ChangesOfScene(scene, image, views) },
    { habits.Isovalues, ChangesOfIsovalues(scene, views) },
    { habits.ImageCache, ChangesOfImageCache(scene, views) },
    { habits.Isomap, ChangesOfIsomap(scene, views) },
  };
  Sweep::Routes routes;
  Expect(views.Render(), "rendered first");
  for (int step = 0; step < steps; ++step)
  {
    const std::string what = "seed " + std::to_string(seed) + ", step " + std::to_string(step);
    bool isOfData = false;
    for (const auto& [often, changes] : kinds)
    {
      if (views.Pick(12) < often)
      {
        const auto which = static_cast<std::size_t>(views.Pick(static_cast<int>(changes.size())));
        changes[which].Make();
        isOfData = isOfData || changes[which].IsOfData;
      }
    }
    Expect(views.Render(), what + ": rendered");
    // What is as it was before the last frame may have an isomap still.
    // Where other samples are not seen, the last picture is copied.
    const bool isCopied = isOfData && IsRoute(scene, "ImageCache");
    Expect(!isOfData || isCopied || IsRoute(scene, "Cold") || IsRoute(scene, "IsomapLookup"),
      what + ": other data are drawn by " + scene.Mapper->GetRouteAsString());
    ExpectPromise(scene, cold, what);
    Expect(!isCopied || cold.IsIdentical(scene), what + ": copied, but not the cold picture");
    ++routes[scene.Mapper->GetRouteAsString()];
    if (views.Pick(8) == 0)
    {
      ExpectRefined(scene, views, cold, what);
    }
  }
  return routes;
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
