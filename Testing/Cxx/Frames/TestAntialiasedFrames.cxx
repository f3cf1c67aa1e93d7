// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// When pictures are antialiased: in windows when nothing changes, in images at once, always, or
// never. Whatever was drawn before, a picture is that of a new mapper, with one ray a pixel or
// antialiased. Threads do not matter. A stop leaves the last picture.

#include "Checks/Expect.h"
#include "Checks/Stopper.h"
#include "Scenes/Scene.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"
#include "Walks/FeatureChanges.h"
#include "Walks/RandomViews.h"

#include <vtkDataArray.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <cstdlib>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

constexpr int Width = 90, Height = 70;

/// Waves, in pictures such as windows show them.
struct StillScene : Scene
{
  explicit StillScene(const std::vector<double>& isovalues = { 200.0, -300.0 })
    : Scene(Volumes::Waves(), isovalues)
  {
    this->Mapper->SetAntialiasingToWhenStill();
    this->Mapper->ProgressiveImagesOn();
    this->LookFrom(1.0, 2.0, 0.5);
  }

  /// Make a frame; its route and whether it is final are as expected.
  void ExpectFrame(const std::string& route, bool isFinal, const std::string& what)
  {
    Expect(this->Render(Width, Height), what + ": rendered");
    Expect(IsRoute(*this, route),
      what + ": the route is " + this->Mapper->GetStatistics()->GetRouteAsString());
    Expect(this->Mapper->GetFrameIsFinal() == isFinal, what + ": final or not");
  }

  /// The last frame is that of a new mapper.
  void ExpectPicture(int antialiasing, const std::string& what)
  {
    ColdWitness cold;
    cold.Mapper->SetAntialiasing(antialiasing);
    Expect(cold.Draw(*this), what + ": a new mapper draws it");
    Expect(cold.IsIdentical(*this), what + ": the picture of a new mapper");
  }
};

vtkSmartPointer<vtkImageData> CopyOf(vtkImageData* image)
{
  const auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(image);
  return copy;
}

void SetOpacity(Scene& scene, double opacity)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, opacity);
  scene.Volume->GetProperty()->SetScalarOpacity(function);
}

void TestStillAndMoving(const std::string& kind, const std::function<void(Scene&)>& prepare)
{
  StillScene scene;
  prepare(scene);
  const std::string what = kind + ", ";
  scene.ExpectFrame("Cold", false, what + "first frame");
  scene.ExpectPicture(Mapper::ANTIALIASING_OFF, what + "first frame");
  scene.ExpectFrame("Antialias", true, what + "second frame");
  scene.ExpectPicture(Mapper::ANTIALIASING_ALWAYS, what + "second frame");
  Expect(scene.Mapper->GetStatistics()->GetNumberOfTracedRays() > 0, what + "some rays");
  scene.ExpectFrame("Redisplay", true, what + "third frame");
  scene.ExpectPicture(Mapper::ANTIALIASING_ALWAYS, what + "third frame");

  scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  scene.ExpectFrame("Cold", false, what + "turned");
  scene.ExpectPicture(Mapper::ANTIALIASING_OFF, what + "turned");
  scene.ExpectFrame("Antialias", true, what + "at rest");

  scene.Mapper->SetAntialiasingToOff();
  scene.ExpectFrame("Antialias", true, what + "off");
  scene.ExpectPicture(Mapper::ANTIALIASING_OFF, what + "off");
  scene.ExpectFrame("Redisplay", true, what + "off again");
  scene.Mapper->SetAntialiasingToAlways();
  scene.ExpectFrame("Antialias", true, what + "on again");
  scene.ExpectPicture(Mapper::ANTIALIASING_ALWAYS, what + "on again");
  scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  scene.ExpectFrame("Cold", true, what + "always");
  scene.ExpectPicture(Mapper::ANTIALIASING_ALWAYS, what + "always");
}

/// New colours, opacities, isovalues and samples in a still view begin with one ray a pixel.
void TestOtherRoutes()
{
  StillScene scene;
  scene.ExpectFrame("Cold", false, "routes");
  const auto rest = [&](const std::string& what)
  {
    scene.ExpectPicture(Mapper::ANTIALIASING_OFF, what);
    scene.ExpectFrame("Antialias", true, what + ", at rest");
    scene.ExpectPicture(Mapper::ANTIALIASING_ALWAYS, what + ", at rest");
  };
  rest("first");
  scene.Volume->GetProperty()->SetAmbient(0.4);
  scene.ExpectFrame("Reshade", false, "colours");
  rest("colours");
  SetOpacity(scene, 0.4);
  scene.ExpectFrame("Recomposite", false, "opacity");
  rest("opacity");
  SetOpacity(scene, 1.0);
  scene.ExpectFrame("Recomposite", false, "opaque");
  rest("opaque");
  scene.SetIsovalues({ 210.0, -300.0 });
  scene.ExpectFrame("IsomapBuild", false, "isovalue");
  rest("isovalue");
  vtkDataArray* samples =
    static_cast<vtkImageData*>(scene.Mapper->GetInput())->GetPointData()->GetScalars();
  for (const std::string route : { "Cold", "TimeStep", "TimeStep" })
  {
    samples->SetTuple1(16 + 32 * (16 + 32 * 16), 900.0 - samples->GetTuple1(5));
    samples->SetTuple1(5, samples->GetTuple1(5) + 1.0);
    samples->Modified();
    scene.Mapper->GetInput()->Modified();
    Expect(scene.Render(Width, Height), "samples");
    rest("samples, " + std::string(scene.Mapper->GetStatistics()->GetRouteAsString()));
  }
}

/// Images are antialiased at once, unless frames as in windows are asked for.
void TestImages()
{
  StillScene scene;
  scene.Mapper->ProgressiveImagesOff();
  scene.ExpectFrame("Cold", true, "image");
  scene.ExpectPicture(Mapper::ANTIALIASING_ALWAYS, "image");
  scene.ExpectFrame("Redisplay", true, "image again");
  scene.Volume->GetProperty()->SetAmbient(0.4);
  scene.ExpectFrame("Reshade", true, "image in other colours");
  scene.ExpectPicture(Mapper::ANTIALIASING_ALWAYS, "image in other colours");
  scene.Mapper->SetAntialiasingToOff();
  scene.Volume->GetProperty()->SetAmbient(0.2);
  scene.ExpectFrame("Reshade", true, "image, off");
  scene.ExpectPicture(Mapper::ANTIALIASING_OFF, "image, off");
}

/// Whatever changes, a picture is that of a new mapper.
void TestRandomChanges(unsigned seed)
{
  Scene scene(Volumes::Waves(), { 200.0, -300.0 });
  scene.Mapper->ProgressiveImagesOn();
  RandomViews views(scene, seed, 50);
  std::vector<Change> changes;
  for (const auto& some : { FeatureChanges::OfRegion(scene, views),
         FeatureChanges::OfOpacity(scene, views), FeatureChanges::OfLists(scene, views),
         FeatureChanges::OfAppearance(scene, views), FeatureChanges::OfVolume(scene, views) })
  {
    changes.insert(changes.end(), some.begin(), some.end());
  }
  ColdWitness cold;
  int smooth = 0;
  std::set<std::string> routes;
  for (int step = 0; step < 120; ++step)
  {
    const std::string what = "seed " + std::to_string(seed) + ", step " + std::to_string(step);
    const bool isRepeated = step > 0 && views.Pick(3) == 0;
    if (views.Pick(6) == 0)
    {
      scene.Mapper->SetAntialiasing(views.Pick(3));
    }
    if (!isRepeated)
    {
      views.Pick(3) == 0
        ? views.Move()
        : changes[static_cast<std::size_t>(views.Pick(static_cast<int>(changes.size())))].Make();
    }
    Expect(views.Render(), what + ": rendered");
    // A change may change nothing.
    const std::string route = scene.Mapper->GetStatistics()->GetRouteAsString();
    const int when = scene.Mapper->GetAntialiasing();
    const bool isStill = route == "Antialias" || route == "Redisplay";
    Expect(!isRepeated || isStill, what + ": nothing changed, but the route is " + route);
    const bool isSmooth =
      when == Mapper::ANTIALIASING_ALWAYS || (when == Mapper::ANTIALIASING_WHEN_STILL && isStill);
    cold.Mapper->SetAntialiasing(isSmooth ? Mapper::ANTIALIASING_ALWAYS : Mapper::ANTIALIASING_OFF);
    Expect(cold.Draw(scene), what + ": a new mapper draws it");
    Expect(cold.IsIdentical(scene), what + ", " + route + ": the picture of a new mapper");
    Expect(scene.Mapper->GetFrameIsFinal() == (isSmooth || when == Mapper::ANTIALIASING_OFF),
      what + ", " + route + ": final or not");
    smooth += isSmooth;
    routes.insert(route);
  }
  Expect(smooth > 10, "some pictures are antialiased");
  for (const std::string route : { "Cold", "Antialias", "Redisplay", "Reshade", "Recomposite" })
  {
    Expect(routes.count(route) == 1, "seed " + std::to_string(seed) + ": route " + route);
  }
}

void TestThreads(const std::string& kind, const std::function<void(Scene&)>& prepare)
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (const int threads : { 1, 2 })
  {
    StillScene scene;
    prepare(scene);
    scene.Mapper->SetAntialiasingToAlways();
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]() { Expect(scene.Render(Width, Height), kind + ": rendered"); });
    pictures.push_back(CopyOf(scene.Color));
  }
  Expect(AreIdentical(pictures[0], pictures[1]), kind + ": threads do not matter");
}

void TestStops(const std::string& kind, const std::function<void(Scene&)>& prepare)
{
  StillScene scene;
  prepare(scene);
  scene.ExpectFrame("Cold", false, kind + ", before a stop");
  const auto before = CopyOf(scene.Color);
  int stopped = 0;
  for (int report = 0; report < 3; ++report)
  {
    const Stopper stopper(scene.Mapper, report);
    vtkNew<vtkImageData> color, depth;
    if (!scene.Render(Width, Height))
    {
      ++stopped;
      scene.GetLastFrame(color, depth);
      Expect(AreIdentical(before, color), kind + ": a stop leaves the last picture");
    }
  }
  Expect(stopped > 0, kind + ": stopped");
  Expect(scene.Render(Width, Height) && scene.Mapper->GetFrameIsFinal(), kind + ": goes on");
  scene.ExpectPicture(Mapper::ANTIALIASING_ALWAYS, kind + ", after a stop");
}

/// With ambient occlusion edges and light get better together, until both are final.
void TestWithOcclusion()
{
  StillScene scene({ 200.0 });
  scene.Mapper->AmbientOcclusionOn();
  scene.Mapper->SetAmbientOcclusionRays(64);
  Expect(scene.Render(Width, Height), "with occlusion");
  Expect(!scene.Mapper->GetFrameIsFinal(), "not final");
  int frames = 0;
  for (; !scene.Mapper->GetFrameIsFinal() && frames < 20; ++frames)
  {
    Expect(scene.Render(Width, Height), "with occlusion");
  }
  Expect(frames < 20, "light and edges become final");
  int covered = 0;
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    const unsigned char alpha = scene.ColorAt(pixel % Width, pixel / Width)[3];
    covered += alpha > 0 && alpha < 255;
  }
  Expect(covered > 20, "edges are antialiased");
  const auto final = CopyOf(scene.Color);
  scene.ExpectFrame("Redisplay", true, "with occlusion, final");
  Expect(AreIdentical(final, scene.Color), "a final picture stays");
}

}

int TestAntialiasedFrames(int, char*[])
{
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> kinds = {
    { "opaque", [](Scene&) {} },
    { "translucent", [](Scene& scene) { SetOpacity(scene, 0.5); } },
    { "THRESHOLD", [](Scene& scene) { scene.Mapper->SetSurfaceModeToThreshold(); } },
    { "composite",
      [](Scene& scene)
      {
        scene.Mapper->SetBlendModeToComposite();
        scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.05);
        vtkNew<vtkPiecewiseFunction> opacity;
        opacity->AddPoint(150.0, 0.0);
        opacity->AddPoint(250.0, 0.8);
        scene.Volume->GetProperty()->SetScalarOpacity(opacity);
      } },
    { "nothing to see", [](Scene& scene) { scene.SetIsovalues({ 1e6 }); } },
  };
  for (const auto& kind : kinds)
  {
    if (kind.first != "nothing to see")
    {
      TestStillAndMoving(kind.first, kind.second);
      TestStops(kind.first, kind.second);
    }
    TestThreads(kind.first, kind.second);
  }
  TestOtherRoutes();
  TestImages();
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    TestRandomChanges(seed);
  }
  TestWithOcclusion();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
