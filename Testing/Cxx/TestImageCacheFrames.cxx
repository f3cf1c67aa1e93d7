// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// When frames are made from the image cache, what they tell of themselves, and that none ever shows
// what was true before.

#include "ColdWitness.h"
#include "Expect.h"
#include "RandomViews.h"
#include "Volumes.h"

#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

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
    what + ": the route is " + scene.Mapper->GetRouteAsString() + ", not " + route);
}

void TestRefineWhenStill()
{
  ColdWitness cold;
  for (const int accuracy : { Mapper::BOUNDED, Mapper::PAPER })
  {
    Scene scene(Volumes::Waves(), { 200.0, -300.0 });
    scene.Mapper->SetReuseAccuracy(accuracy);
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
  scene.Mapper->ImageCacheOff();
  ExpectRoute(scene, "Cold", "image cache off");
  Expect(cold.Draw(scene) && cold.IsIdentical(scene), "image cache off: not the cold picture");
}

void TestKeyImages()
{
  Scene scene(Volumes::Waves(), { 200.0 });
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
  scene.Mapper->SetNumberOfCachedImages(numberOfImages);
  scene.LookFrom(-1.0, -2.0, 0.8);
  const std::string what = std::to_string(numberOfImages) + " image(s)";
  ExpectRoute(scene, "Cold", what + ", first");
  for (const double degrees : { 70.0, 70.0, -139.0 })
  {
    Turn(scene, degrees);
    ExpectRoute(scene, "ImageCache", what + ", jump");
  }
  return scene.Mapper->GetNumberOfPossibleHits();
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
  for (const int accuracy : { Mapper::BOUNDED, Mapper::EXACT, Mapper::PAPER })
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
      Expect(mapper->GetNumberOfRays() == scene.Depth->GetNumberOfPoints(), what + ": rays");
      Expect(mapper->GetNumberOfDefiniteHits() + mapper->GetNumberOfDefiniteMisses() +
            mapper->GetNumberOfPossibleHits() ==
          mapper->GetNumberOfRays(),
        what + ": answers add up to rays");
      Expect(mapper->GetNumberOfTracedRays() <= mapper->GetNumberOfRays(), what + ": traced rays");
      const bool isAsked = IsRoute(scene, "ImageCache") && accuracy != Mapper::EXACT;
      Expect((mapper->GetQueryTime() > 0.0) == isAsked, what + ": the time of asking");
      const double sum = mapper->GetTraceTime() + mapper->GetQueryTime() + mapper->GetShadeTime();
      Expect(sum <= mapper->GetFrameTime() + 1e-6, what + ": times add up");
    }
  }
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
  for (const int accuracy : { Mapper::BOUNDED, Mapper::PAPER })
  {
    Scene scene(Volumes::Waves(), { 200.0, -300.0 });
    scene.Mapper->SetReuseAccuracy(accuracy);
    scene.Mapper->ColorByAnswerOn();
    scene.LookFrom(1.0, 2.0, 0.5);
    ColdWitness cold;
    ExpectRoute(scene, "Cold", "by answer");
    Expect(CountYellow(scene, "cold") == 0, "a cold frame is yellow");
    Turn(scene, 20.0);
    ExpectRoute(scene, "ImageCache", "by answer");
    const vtkIdType yellow = CountYellow(scene, "turned");
    Expect(yellow > 0, "nothing is yellow after a large turn");
    Expect(yellow <= scene.Mapper->GetNumberOfPossibleHits(), "more is yellow than possible");
    ExpectRoute(scene, "Cold", "by answer, still");
    Expect(cold.Draw(scene) && cold.IsIdentical(scene), "by answer, still: not the cold picture");
  }
}

/// Something to change. What is changed of the data makes every kept picture worthless.
struct Change
{
  bool IsOfData;
  std::function<void()> Make;
};

void AddLight(Scene& scene, RandomViews& views)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(views.Between(-3.0, 3.0), views.Between(-3.0, 3.0), 3.0);
  light->SetIntensity(0.3);
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(light);
}

std::vector<Change> ChangesOfScene(Scene& scene, vtkImageData* image, RandomViews& views)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  return {
    { true,
      [=, &views]
      {
        vtkDataArray* scalars = image->GetPointData()->GetScalars();
        const vtkIdType at = views.Pick(31000);
        for (vtkIdType i = at; i < at + 400; ++i)
        {
          scalars->SetComponent(i, 0, 1000.0 * views.Pick(3) - 500.0);
        }
        scalars->Modified();
      } },
    { true, [=, &views] { image->SetOrigin(views.Between(-2.0, 0.0), -1.0, -1.0); } },
    { true, [=, &views] { image->SetSpacing(views.Between(0.05, 0.08), 0.065, 0.065); } },
    { true, [&] { scene.Volume->RotateX(views.Between(1.0, 30.0)); } },
    { true, [&] { scene.Volume->SetScale(1.0, views.Between(0.8, 1.2), 1.0); } },
    { true, [=] { property->SetInterpolationType(1 - property->GetInterpolationType()); } },
    // A picture of the same mode may still be kept.
    { false, [&] { scene.Mapper->SetSurfaceMode(1 - scene.Mapper->GetSurfaceMode()); } },
    { false, [&] { scene.SetIsovalues({ views.Between(-900.0, 900.0) }); } },
    { false,
      [&] {
        scene.SetIsovalues({ views.Between(0.0, 500.0), views.Between(-500.0, 0.0) });
      } },
    { false, [=] { property->SetAmbient(property->GetAmbient() > 0.3 ? 0.1 : 0.5); } },
    { false,
      [=, &views]
      {
        property->GetRGBTransferFunction()->AddRGBPoint(
          views.Between(-500.0, 500.0), 0.1, views.Between(0.0, 1.0), 0.9);
      } },
    { false, [&] { AddLight(scene, views); } },
  };
}

std::vector<Change> ChangesOfView(Scene& scene, RandomViews& views)
{
  const auto move = [&] { views.Move(); };
  const auto project = [&scene]
  {
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(1 - camera->GetParallelProjection());
  };
  return { { false, move }, { false, move }, { false, move }, { false, move }, { false, move },
    { false, move }, { false, project }, { false, [&] { views.Resize(); } }, { false, [] {} } };
}

std::vector<Change> ChangesOfSettings(Mapper* mapper, RandomViews& views)
{
  return {
    { false, [=] { mapper->SetSpaceLeaping(1 - mapper->GetSpaceLeaping()); } },
    { false, [=, &views] { mapper->SetImageCache(views.Pick(4) != 0); } },
    { false, [=, &views] { mapper->SetReuseAccuracy(views.Pick(3)); } },
    { false, [=, &views] { mapper->SetImageCachePolicy(views.Pick(2)); } },
    { false, [=, &views] { mapper->SetNumberOfCachedImages(1 + views.Pick(4)); } },
    { false, [=, &views] { mapper->SetKeyImageInterval(1 + views.Pick(6)); } },
    { false, [=, &views] { mapper->SetImageCacheShading(views.Pick(2)); } },
    { false, [=] { mapper->SetColorByAnswer(1 - mapper->GetColorByAnswer()); } },
  };
}

/// Hold a frame against what its accuracy and route promise.
void ExpectPromise(Scene& scene, ColdWitness& cold, const std::string& what)
{
  Mapper* mapper = scene.Mapper;
  Expect(cold.Draw(scene), what + ": rendered cold");
  const bool isFromCache = IsRoute(scene, "ImageCache");
  if (!isFromCache || mapper->GetReuseAccuracy() == Mapper::EXACT)
  {
    Expect(cold.IsDepthIdentical(scene), what + ": not the cold depths");
    Expect(
      mapper->GetColorByAnswer() || cold.IsColorIdentical(scene), what + ": not the cold colours");
  }
  else if (mapper->GetReuseAccuracy() == Mapper::BOUNDED)
  {
    const vtkIdType different = cold.CountDifferent(scene);
    const auto pixels = static_cast<double>(scene.Depth->GetNumberOfPoints());
    Expect(static_cast<double>(different) <= 5e-4 * pixels + 3.0,
      what + ": BOUNDED, " + std::to_string(different) + " pixels differ");
  }
}

/// A view that repeats ends in the cold picture.
void ExpectRefined(Scene& scene, RandomViews& views, ColdWitness& cold, const std::string& what)
{
  Expect(views.Render(), what + ": rendered again");
  Expect(cold.IsDepthIdentical(scene) &&
      (scene.Mapper->GetColorByAnswer() || cold.IsColorIdentical(scene)),
    what + ": not the cold picture when rendered again");
}

/// Changes in random order, up to three at a time.
void TestNeverStale(unsigned seed)
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 0.0 });
  RandomViews views(scene, seed, 80);
  ColdWitness cold;
  const std::vector<Change> ofScene = ChangesOfScene(scene, image, views);
  const std::vector<Change> ofView = ChangesOfView(scene, views);
  const std::vector<Change> ofSettings = ChangesOfSettings(scene.Mapper, views);
  int fromCache = 0;
  for (int step = 0; step < 500; ++step)
  {
    const std::string what = "seed " + std::to_string(seed) + ", step " + std::to_string(step);
    bool isOfData = step == 0;
    const auto makeOne = [&](const std::vector<Change>& changes)
    {
      const Change& change =
        changes[static_cast<std::size_t>(views.Pick(static_cast<int>(changes.size())))];
      change.Make();
      isOfData = isOfData || change.IsOfData;
    };
    makeOne(ofView);
    if (views.Pick(3) == 0)
    {
      makeOne(ofScene);
    }
    if (views.Pick(4) == 0)
    {
      makeOne(ofSettings);
    }
    Expect(views.Render(), what + ": rendered");
    Expect(!isOfData || IsRoute(scene, "Cold"), what + ": other data are not drawn cold");
    ExpectPromise(scene, cold, what);
    fromCache += IsRoute(scene, "ImageCache");
    if (views.Pick(8) == 0)
    {
      ExpectRefined(scene, views, cold, what);
    }
  }
  Expect(fromCache > 100, "only " + std::to_string(fromCache) + " frames are from the cache");
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
  TestNeverStale(7);
  TestNeverStale(8);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
