// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Isomaps are built, looked up and dropped when they should be, and keep to their limits of memory.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

/// A picture that the tests below show again and again.
struct Waves
{
  explicit Waves(int width = 96, int height = 80)
    : Image(Volumes::Waves())
    , Shown(this->Image, { 200.0 })
    , Width(width)
    , Height(height)
  {
    this->Shown.LookFrom(1.0, 2.0, 0.5);
  }

  /// Show an isovalue by the route, and the cold picture of it.
  void Expect(double isovalue, const std::string& route, const std::string& what)
  {
    this->Shown.SetIsovalues({ isovalue });
    this->Expect(route, what);
  }

  void Expect(const std::string& route, const std::string& what)
  {
    ::Expect(this->Shown.Render(this->Width, this->Height), what + ": rendered");
    ::Expect(IsRoute(this->Shown, route),
      what + ": the route is " + this->Shown.Mapper->GetStatistics()->GetRouteAsString() +
        ", not " + route);
    ::Expect(this->Cold.Draw(this->Shown) && this->Cold.IsIdentical(this->Shown),
      what + ": not the cold picture");
  }

  void Turn(double degrees)
  {
    this->Shown.Renderer->GetActiveCamera()->Azimuth(degrees);
    this->Shown.Renderer->ResetCameraClippingRange();
  }

  vtkSmartPointer<vtkImageData> Image;
  Scene Shown;
  ColdWitness Cold;
  int Width, Height;
};

void TestRoutesOfIsovalues()
{
  Waves waves;
  Mapper* mapper = waves.Shown.Mapper;
  mapper->SetIsomapRange(150.0, 250.0);
  waves.Expect("Cold", "first");
  Expect(mapper->GetStatistics()->GetIsomapMemory() == 0 &&
      mapper->GetStatistics()->GetNumberOfIsomapKnots() == 0,
    "there is an isomap before an isovalue changed");
  waves.Expect(210.0, "IsomapBuild", "first change");
  Expect(mapper->GetStatistics()->GetIsomapBuildTime() > 0.0, "building takes time");
  Expect(mapper->GetStatistics()->GetIsomapMemory() > 0 &&
      mapper->GetStatistics()->GetNumberOfIsomapKnots() > 0,
    "it is kept");
  waves.Expect("Redisplay", "nothing");
  waves.Shown.Volume->GetProperty()->SetAmbient(0.4);
  waves.Expect("Reshade", "new colours");
  waves.Expect(-900.0, "IsomapBuild", "far away");
  const vtkIdType knots = mapper->GetStatistics()->GetNumberOfIsomapKnots();
  waves.Expect(210.0, "IsomapLookup", "back again");
  Expect(mapper->GetStatistics()->GetIsomapBuildTime() == 0.0, "looking up builds nothing");
  Expect(mapper->GetStatistics()->GetNumberOfIsomapKnots() == knots, "looking up changes no knots");
  Expect(mapper->GetStatistics()->GetNumberOfRays() == 96 * 80 &&
      mapper->GetStatistics()->GetNumberOfDefiniteHits() +
          mapper->GetStatistics()->GetNumberOfDefiniteMisses() +
          mapper->GetStatistics()->GetNumberOfPossibleHits() ==
        mapper->GetStatistics()->GetNumberOfRays(),
    "answers add up to rays");
  Expect(mapper->GetStatistics()->GetNumberOfTracedRays() <=
      mapper->GetStatistics()->GetNumberOfRays() / 100,
    "rays that are looked up are traced");
  waves.Shown.SetIsovalues({});
  waves.Expect("Cold", "no isovalues");
}

void TestGivenRange()
{
  Waves waves;
  waves.Shown.Mapper->SetIsomapRange(-200.0, 400.0);
  waves.Expect("Cold", "range, first");
  waves.Expect(205.0, "IsomapBuild", "range, first change");
  for (const double isovalue : { -200.0, 400.0, 0.0, 399.9, 17.0, 18.0 })
  {
    waves.Expect(isovalue, "IsomapLookup", "range, " + std::to_string(isovalue));
  }
  waves.Expect(500.0, "IsomapBuild", "outside of the range");
  waves.Expect(100.0, "IsomapLookup", "in the range again");
  waves.Shown.SetIsovalues({ 100.0, -150.0, 300.0 });
  waves.Expect("IsomapLookup", "three in the range");
}

void TestBuiltAhead()
{
  Waves waves;
  Scene& scene = waves.Shown;
  scene.Mapper->SetIsomapRange(100.0, 300.0);
  waves.Expect("Cold", "ahead, first");
  Expect(scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume), "built ahead");
  Expect(scene.Mapper->GetStatistics()->GetIsomapMemory() > 0, "built ahead: it is kept");
  Expect(IsRoute(scene, "Cold"), "built ahead: the last frame stays");
  waves.Expect("Redisplay", "built ahead, nothing changed");
  waves.Expect(299.0, "IsomapLookup", "built ahead, changed");
  Expect(scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume), "there already");

  Waves narrow;
  Scene& other = narrow.Shown;
  narrow.Expect("Cold", "a narrow band, first");
  Expect(other.Mapper->BuildIsomap(other.Renderer, other.Volume), "a narrow band is built ahead");
  narrow.Expect(200.001, "IsomapLookup", "a narrow band, changed");

  // Of a view that was not shown yet.
  other.LookFrom(-1.0, 0.3, 0.2);
  Expect(other.Mapper->BuildIsomap(other.Renderer, other.Volume), "built for the next view");
  narrow.Expect("IsomapLookup", "the next view");
}

/// An isomap stays where it is while the camera is elsewhere.
void TestReturn()
{
  Waves waves;
  waves.Shown.Mapper->SetIsomapRange(150.0, 250.0);
  waves.Expect("Cold", "return, first");
  waves.Expect(230.0, "IsomapBuild", "return, changed");
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(waves.Shown.Renderer->GetActiveCamera());
  waves.Turn(5.0);
  waves.Expect("Cold", "elsewhere");
  waves.Shown.Renderer->GetActiveCamera()->DeepCopy(camera);
  waves.Expect("IsomapLookup", "returned");
  waves.Turn(5.0);
  waves.Expect("Cold", "elsewhere again");
  waves.Expect(-100.0, "IsomapBuild", "elsewhere, changed");
}

/// After any other change nothing that was built before is shown.
void TestNothingStale()
{
  const std::vector<std::pair<std::string, std::function<void(Waves&)>>> changes = {
    { "samples",
      [](Waves& waves)
      {
        vtkDataArray* scalars = waves.Image->GetPointData()->GetScalars();
        for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
        {
          scalars->SetComponent(i, 0, 0.5 * scalars->GetComponent(i, 0) + 100.0);
        }
        scalars->Modified();
      } },
    { "another image",
      [](Waves& waves)
      { waves.Shown.Mapper->SetInputData(Volumes::Noise(12, VTK_SHORT, -900.0, 900.0)); } },
    { "origin", [](Waves& waves) { waves.Image->SetOrigin(-1.1, -1.0, -1.0); } },
    { "transform", [](Waves& waves) { waves.Shown.Volume->RotateX(10.0); } },
    { "interpolation",
      [](Waves& waves) { waves.Shown.Volume->GetProperty()->SetInterpolationTypeToNearest(); } },
    { "mode", [](Waves& waves) { waves.Shown.Mapper->SetSurfaceModeToThreshold(); } },
    { "picture's size", [](Waves& waves) { waves.Width = 90; } },
    { "view angle",
      [](Waves& waves) { waves.Shown.Renderer->GetActiveCamera()->SetViewAngle(31.0); } },
    { "clipping range",
      [](Waves& waves) { waves.Shown.Renderer->GetActiveCamera()->SetClippingRange(3.0, 5.0); } },
  };
  for (const auto& [name, change] : changes)
  {
    for (const bool isWithIsovalue : { false, true })
    {
      Waves waves;
      waves.Shown.Mapper->ReuseFramesOff();
      waves.Shown.Mapper->SetIsomapRange(-500.0, 500.0);
      waves.Expect("Cold", name + ", first");
      waves.Expect(300.0, "IsomapBuild", name + ", built");
      change(waves);
      waves.Expect(isWithIsovalue ? 250.0 : 300.0, "Cold", name + ", changed");
      waves.Expect(200.0, "IsomapBuild", name + ", built again");
      waves.Expect(300.0, "IsomapLookup", name + ", looked up");
    }
  }
}

/// Camera and isovalue take turns, by every route that an isovalue's change can take.
void TestTakingTurns()
{
  for (const bool isMapped : { true, false })
  {
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      Waves waves(200, 160);
      waves.Shown.Mapper->SetIsomap(isMapped);
      waves.Shown.Mapper->SetSurfaceMode(mode);
      const std::string what = "taking turns, isomap " + std::to_string(isMapped) + ", mode " +
        std::to_string(mode) + ", step ";
      waves.Expect("Cold", what + "0");
      for (int step = 1; step < 60; ++step)
      {
        const double isovalue = 200.0 + 13.0 * (step % 17) - (step % 5 == 0 ? 300.0 : 0.0);
        waves.Expect(isovalue, isMapped ? "IsomapBuild" : "Cold", what + std::to_string(step));
        if (step % 3 == 0)
        {
          waves.Shown.SetIsovalues({ isovalue + 40.0 });
          Expect(waves.Shown.Render(200, 160) && waves.Cold.Draw(waves.Shown) &&
              waves.Cold.IsIdentical(waves.Shown),
            what + std::to_string(step) + ": a second isovalue is not the cold picture");
        }
        for (int turn = 0; turn < 1 + step % 4; ++turn)
        {
          waves.Turn(step % 2 ? 3.0 : -1.5);
          waves.Expect("Cold", what + std::to_string(step) + ", turn");
        }
      }
    }
  }
}

/// A picture that was looked up is left as any other.
void TestOrbitAfterLookup()
{
  Waves waves(200, 160);
  waves.Shown.Mapper->SetIsomapRange(200.0, 300.0);
  waves.Expect("Cold", "orbit, first");
  waves.Expect(250.0, "IsomapBuild", "orbit, built");
  waves.Expect(120.0, "IsomapBuild", "orbit, built below");
  waves.Expect(250.0, "IsomapLookup", "orbit, looked up");
  for (int frame = 0; frame < 10; ++frame)
  {
    waves.Turn(1.0);
    waves.Expect("Cold", "orbit after a look-up, frame " + std::to_string(frame));
  }
}

/// Answers are told of frames from the image cache only, not of those looked up after them.
void TestColorByAnswer()
{
  for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
  {
    const std::string what = "by answer, mode " + std::to_string(mode);
    Waves waves;
    waves.Shown.Mapper->SetSurfaceMode(mode);
    waves.Shown.Mapper->ColorByAnswerOn();
    waves.Shown.Mapper->SetReuseAccuracyToPaper();
    waves.Expect("Cold", what + ", first");
    const auto turn = [&](const std::string& turned)
    {
      waves.Turn(10.0);
      Expect(waves.Shown.Render(waves.Width, waves.Height) && IsRoute(waves.Shown, "ImageCache"),
        what + turned);
    };
    for (int i = 0; i < 3; ++i)
    {
      turn(", turned");
    }
    waves.Expect(250.0, "IsomapBuild", what + ", built");
    turn(", turned again");
    waves.Expect(-250.0, "IsomapBuild", what + ", built again");
    waves.Expect(-250.0, "Redisplay", what + ", still");
  }
}

/// A sweep through more than fits: exact, within the limit, with one warning.
void TestMemoryLimit()
{
  Scene scene(Volumes::Noise(24, VTK_FLOAT, -1000.0, 1000.0), { 0.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  scene.Mapper->SetIsomapMemoryLimit(1);
  scene.Mapper->WarnOfIsovaluesOff(); // some lie outside the range: of these another test tells
  EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  ColdWitness cold;
  constexpr vtkIdType limit = 1 << 20;
  vtkIdType most = 0;
  for (int step = 0; step < 150; ++step)
  {
    const std::string what = "limit of memory, step " + std::to_string(step);
    const double isovalue = -1100.0 + 2200.0 * (step * 61 % 150) / 150.0;
    scene.SetIsovalues({ isovalue });
    scene.Mapper->SetIsomapRange(isovalue - 3.0, isovalue + 3.0);
    Expect(scene.Render(240, 200), what + ": rendered");
    most = std::max(most, scene.Mapper->GetStatistics()->GetIsomapMemory());
    Expect(scene.Mapper->GetStatistics()->GetIsomapMemory() <= limit,
      what + ": " + std::to_string(scene.Mapper->GetStatistics()->GetIsomapMemory()) + " bytes");
    if (step % 5 == 0)
    {
      Expect(cold.Draw(scene) && cold.IsIdentical(scene), what + ": not the cold picture");
    }
  }
  Expect(most > limit / 4, "limit of memory: it is not used, the most is " + std::to_string(most));
  Expect(warnings.Count == 1,
    "limit of memory: " + std::to_string(warnings.Count) + " warnings instead of one");

  // The whole range in one band is too large; the picture is right all the same.
  scene.Mapper->ClearCache();
  Expect(scene.Mapper->GetStatistics()->GetIsomapMemory() == 0 &&
      scene.Mapper->GetStatistics()->GetNumberOfIsomapKnots() == 0,
    "ClearCache leaves an isomap");
  scene.Mapper->SetIsomapRange(-1000.0, 1000.0);
  for (const double isovalue : { 500.0, 510.0, -20.0 })
  {
    scene.SetIsovalues({ isovalue });
    Expect(scene.Render(240, 200) && cold.Draw(scene) && cold.IsIdentical(scene),
      "too large a range: not the cold picture");
    Expect(scene.Mapper->GetStatistics()->GetIsomapMemory() <= limit, "too large a range: kept");
  }
}

/// Bands that nobody asked for take at most 32 bytes for each pixel, and no warning tells of that.
void TestMemoryOfDrags()
{
  Scene scene(Volumes::Waves(), { 0.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  for (int step = 0; step < 200; ++step)
  {
    scene.SetIsovalues({ 1200.0 * std::sin(0.03 * step) });
    Expect(scene.Render(240, 200), "memory of drags: rendered");
    Expect(scene.Mapper->GetStatistics()->GetIsomapMemory() <= 33 * 240 * 200,
      "memory of drags: " + std::to_string(scene.Mapper->GetStatistics()->GetIsomapMemory()) +
        " bytes");
  }
  Expect(warnings.Count == 0, "memory of drags: a warning");
}

/// A limit that is lowered holds from the next frame on.
void TestLoweredLimit()
{
  Scene scene(Volumes::Noise(24, VTK_FLOAT, -1000.0, 1000.0), { 0.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  ColdWitness cold;
  for (int step = 0; step < 60; ++step)
  {
    const double isovalue = -900.0 + 30.0 * step;
    scene.SetIsovalues({ isovalue });
    scene.Mapper->SetIsomapRange(isovalue - 10.0, isovalue + 10.0);
    Expect(scene.Render(240, 200), "limit to be lowered: rendered");
  }
  const vtkIdType before = scene.Mapper->GetStatistics()->GetIsomapMemory();
  Expect(before > (2 << 20), "limit to be lowered: only " + std::to_string(before) + " bytes");
  Expect(warnings.Count == 0, "limit to be lowered: a warning");
  for (const int limit : { 2, 1, 0 })
  {
    scene.Mapper->SetIsomapMemoryLimit(limit);
    scene.SetIsovalues({ 100.0 + limit });
    Expect(scene.Render(240, 200) && cold.Draw(scene) && cold.IsIdentical(scene),
      "lowered limit: not the cold picture");
    Expect(scene.Mapper->GetStatistics()->GetIsomapMemory() <= static_cast<vtkIdType>(limit) << 20,
      "limit lowered to " + std::to_string(limit) +
        " MiB: " + std::to_string(scene.Mapper->GetStatistics()->GetIsomapMemory()) + " bytes");
  }
  Expect(IsRoute(scene, "Cold"),
    std::string("limit lowered to 0: the route is ") +
      scene.Mapper->GetStatistics()->GetRouteAsString());
}

/// No memory is no isomap.
void TestNoMemory()
{
  Waves waves;
  waves.Shown.Mapper->SetIsomapMemoryLimit(0);
  EventCounter warnings(waves.Shown.Mapper, vtkCommand::WarningEvent);
  waves.Expect("Cold", "limit 0, first");
  waves.Expect(210.0, "Cold", "limit 0, raised");
  waves.Expect(190.0, "Cold", "limit 0, lowered");
  Expect(
    waves.Shown.Mapper->GetStatistics()->GetIsomapMemory() == 0, "limit 0: there is an isomap");
  Expect(warnings.Count == 0, "limit 0: a warning");
  waves.Shown.Mapper->SetIsomapMemoryLimit(256);
  waves.Expect(180.0, "IsomapBuild", "with memory again");
  waves.Shown.Mapper->IsomapOff();
  waves.Expect(190.0, "Cold", "isomap off");
  waves.Shown.SetIsovalues({ 190.0, 100.0 });
  waves.Expect("Cold", "isomap off, two isovalues");
}

}

int TestIsomapFrames(int, char*[])
{
  TestRoutesOfIsovalues();
  TestGivenRange();
  TestBuiltAhead();
  TestReturn();
  TestNothingStale();
  TestTakingTurns();
  TestOrbitAfterLookup();
  TestColorByAnswer();
  TestMemoryLimit();
  TestMemoryOfDrags();
  TestLoweredLimit();
  TestNoMemory();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
