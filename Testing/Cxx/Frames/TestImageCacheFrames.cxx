// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Frames are made from the image cache when they should be, and their statistics say so.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Subject.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomViews.h"

#include <vtkCommand.h>

#include <cmath>
#include <cstdlib>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

void Turn(Scene& scene, double degrees)
{
  scene.Renderer->GetActiveCamera()->Azimuth(degrees);
  scene.Renderer->ResetCameraClippingRange();
}

void ExpectRoute(Scene& scene, const std::string& route, const std::string& what)
{
  Expect(scene.Render(150, 120), what + ": rendered");
  Expect(IsRoute(scene, route),
    what + ": the route is " + scene.Mapper->GetStatistics()->GetRouteAsString() + ", not " +
      route);
}

void TestRefineWhenStill()
{
  ColdWitness cold;
  for (const bool isNearest : { false, true })
  {
    Subject waves = { "Waves", Volumes::Waves(), { 200.0, -300.0 } };
    waves.IsNearest = isNearest;
    Scene scene(waves.Image, waves.Isovalues);
    waves.Prepare(scene);
    scene.Mapper->SetReuseAccuracyToPaper();
    scene.LookFrom(1.0, 2.0, 0.5);
    ExpectRoute(scene, "Cold", "first");
    Turn(scene, 4.0);
    ExpectRoute(scene, "ImageCache", "moved");
    ExpectRoute(scene, "Cold", "still");
    Expect(cold.Draw(scene) && cold.IsIdentical(scene), "still: not the cold picture");
    ExpectRoute(scene, "Redisplay", "still again");
    Expect(cold.IsIdentical(scene), "still again: not the cold picture");

    Turn(scene, 4.0);
    ExpectRoute(scene, "ImageCache", "moved again");
    scene.Volume->GetProperty()->SetAmbient(0.4);
    ExpectRoute(scene, "Cold", "new colours");
    Expect(cold.Draw(scene) && cold.IsIdentical(scene), "new colours: not the cold picture");
    scene.Volume->GetProperty()->SetAmbient(0.2);
    ExpectRoute(scene, "Reshade", "new colours of a cold picture");
    Expect(cold.Draw(scene) && cold.IsIdentical(scene), "colours: not the cold picture");
  }
}

void TestNoRefinement()
{
  Scene scene(Volumes::Waves(), { 200.0, -300.0 });
  scene.Mapper->SetReuseAccuracyToPaper();
  scene.Mapper->RefineWhenStillOff();
  scene.LookFrom(1.0, 2.0, 0.5);
  ExpectRoute(scene, "Cold", "first");
  Turn(scene, 4.0);
  ExpectRoute(scene, "ImageCache", "moved");
  vtkNew<vtkImageData> color, depth;
  color->DeepCopy(scene.Color);
  depth->DeepCopy(scene.Depth);
  ExpectRoute(scene, "Redisplay", "still, not refined");
  Expect(AreIdentical(color, scene.Color) && AreIdentical(depth, scene.Depth),
    "still, not refined: another picture");
  scene.Volume->GetProperty()->SetAmbient(0.4);
  ExpectRoute(scene, "Reshade", "new colours, not refined");
  Expect(AreIdentical(depth, scene.Depth) && !AreIdentical(color, scene.Color),
    "new colours, not refined: the surfaces stay, the colours change");
  ColdWitness cold;
  scene.Mapper->ReuseFramesOff();
  ExpectRoute(scene, "Cold", "image cache off");
  Expect(cold.Draw(scene) && cold.IsIdentical(scene), "image cache off: not the cold picture");
}

void TestKeyImages()
{
  Scene scene(Volumes::Waves(), { 200.0 });
  scene.Mapper->SetReuseAccuracyToPaper();
  scene.Mapper->SetImageCachePolicyToKeyImage();
  scene.Mapper->SetKeyImageInterval(5);
  scene.LookFrom(1.0, 2.0, 0.5);
  for (int frame = 0; frame < 23; ++frame)
  {
    ExpectRoute(
      scene, frame % 5 == 0 ? "Cold" : "ImageCache", "key images, frame " + std::to_string(frame));
    Turn(scene, 2.0);
  }
}

/// Possible hits of a view that is near one seen before, two jumps ago.
vtkIdType PossibleHitsAfterReturn(int numberOfImages)
{
  Scene scene(Volumes::Load("spheres64"), { 100.0 });
  scene.Mapper->SetReuseAccuracyToPaper();
  scene.Mapper->SetNumberOfCachedImages(numberOfImages);
  scene.LookFrom(-1.0, -2.0, 0.8);
  const std::string what = std::to_string(numberOfImages) + " image(s)";
  ExpectRoute(scene, "Cold", what + ", first");
  for (const double degrees : { 70.0, 70.0, -139.0 })
  {
    Turn(scene, degrees);
    ExpectRoute(scene, "ImageCache", what + ", jump");
  }
  return scene.Mapper->GetStatistics()->GetNumberOfPossibleHits();
}

void TestSeveralImages()
{
  const vtkIdType one = PossibleHitsAfterReturn(1);
  const vtkIdType three = PossibleHitsAfterReturn(3);
  Expect(three < one,
    "the nearest of three images leaves " + std::to_string(three) +
      " possible hits, the latest alone " + std::to_string(one));
}

void TestCounters()
{
  for (const int accuracy : { Mapper::EXACT, Mapper::PAPER })
  {
    Scene scene(Volumes::Waves(), { 200.0, -300.0 });
    scene.Mapper->SetReuseAccuracy(accuracy);
    RandomViews views(scene, 3, 120);
    for (int step = 0; step < 40; ++step)
    {
      const std::string what =
        "counters, accuracy " + std::to_string(accuracy) + ", step " + std::to_string(step);
      Expect(views.RenderNext(), what + ": rendered");
      Mapper* mapper = scene.Mapper;
      Expect(mapper->GetStatistics()->GetNumberOfRays() == scene.Depth->GetNumberOfPoints(),
        what + ": rays");
      Expect(mapper->GetStatistics()->GetNumberOfDefiniteHits() +
            mapper->GetStatistics()->GetNumberOfDefiniteMisses() +
            mapper->GetStatistics()->GetNumberOfPossibleHits() ==
          mapper->GetStatistics()->GetNumberOfRays(),
        what + ": answers add up to rays");
      Expect(mapper->GetStatistics()->GetNumberOfTracedRays() <=
          mapper->GetStatistics()->GetNumberOfRays(),
        what + ": traced rays");
      const bool isAsked = IsRoute(scene, "ImageCache");
      Expect(!isAsked || accuracy == Mapper::PAPER, what + ": the cache serves EXACT");
      Expect(
        (mapper->GetStatistics()->GetQueryTime() > 0.0) == isAsked, what + ": the time of asking");
      const double sum = mapper->GetStatistics()->GetTraceTime() +
        mapper->GetStatistics()->GetQueryTime() + mapper->GetStatistics()->GetShadeTime();
      Expect(sum <= mapper->GetStatistics()->GetFrameTime() + 1e-6, what + ": times add up");
    }
  }
}

/// What was made for EXACT has not what PAPER starts from.
void TestChangedAccuracy()
{
  Subject nearest = { "Waves", Volumes::Waves(), { 200.0 } };
  nearest.IsNearest = true;
  Scene scene(nearest.Image, nearest.Isovalues);
  nearest.Prepare(scene);
  scene.LookFrom(1.0, 2.0, 0.5);
  ColdWitness cold;
  const auto expect = [&](int accuracy, const std::string& route)
  {
    scene.Mapper->SetReuseAccuracy(accuracy);
    Turn(scene, 1.0);
    ExpectRoute(scene, route, "accuracy " + std::to_string(accuracy));
    Expect(cold.Draw(scene) && cold.CountDifferent(scene) < 200, "no other picture");
  };
  expect(Mapper::EXACT, "Cold");
  expect(Mapper::PAPER, "Cold");
  expect(Mapper::PAPER, "ImageCache");
  expect(Mapper::EXACT, "Cold");
  expect(Mapper::PAPER, "Cold");
  expect(Mapper::PAPER, "ImageCache");
}

/// Programs that ask for the removed accuracy get the default, and are told so once.
void TestRemovedAccuracy()
{
  Scene scene(Volumes::Waves(), { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  scene.Mapper->SetReuseAccuracyToPaper();
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  scene.Mapper->SetReuseAccuracyToBounded();
  Expect(scene.Mapper->GetReuseAccuracy() == Mapper::EXACT && warnings.Count == 1,
    "BOUNDED: EXACT, and a warning");
  ExpectRoute(scene, "Cold", "BOUNDED, first");
  Turn(scene, 1.0);
  ExpectRoute(scene, "Cold", "BOUNDED, turned");
  const vtkMTimeType before = scene.Mapper->GetMTime();
  scene.Mapper->SetReuseAccuracy(Mapper::BOUNDED);
  Expect(warnings.Count == 1 && scene.Mapper->GetMTime() == before, "BOUNDED again: no change");
  Expect(warnings.Count == 1, "no other warning");
}

/// Yellow pixels; and none of them without a surface.
vtkIdType CountYellow(const Scene& scene, const std::string& what)
{
  vtkIdType yellow = 0;
  int size[3];
  scene.Color->GetDimensions(size);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const unsigned char* rgba = scene.ColorAt(x, y);
      if (rgba[0] == 255 && rgba[1] == 255 && rgba[2] == 0)
      {
        ++yellow;
        Expect(rgba[3] == 255 && std::isfinite(scene.DepthAt(x, y)),
          what + ": yellow without a surface");
      }
    }
  }
  return yellow;
}

void TestColorByAnswer()
{
  Scene scene(Volumes::Waves(), { 200.0, -300.0 });
  scene.Mapper->SetReuseAccuracyToPaper();
  scene.Mapper->ColorByAnswerOn();
  scene.LookFrom(1.0, 2.0, 0.5);
  ColdWitness cold;
  ExpectRoute(scene, "Cold", "by answer");
  Expect(CountYellow(scene, "cold") == 0, "a cold frame is yellow");
  Turn(scene, 20.0);
  ExpectRoute(scene, "ImageCache", "by answer");
  const vtkIdType yellow = CountYellow(scene, "turned");
  Expect(yellow > 0, "nothing is yellow after a large turn");
  Expect(yellow <= scene.Mapper->GetStatistics()->GetNumberOfPossibleHits(),
    "more is yellow than possible");
  ExpectRoute(scene, "Cold", "by answer, still");
  Expect(cold.Draw(scene) && cold.IsIdentical(scene), "by answer, still: not the cold picture");
}

}

int TestImageCacheFrames(int, char*[])
{
  TestRefineWhenStill();
  TestNoRefinement();
  TestKeyImages();
  TestSeveralImages();
  TestCounters();
  TestColorByAnswer();
  TestChangedAccuracy();
  TestRemovedAccuracy();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
