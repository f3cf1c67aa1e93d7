// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Building an isomap tells how far it is, can be stopped at any time with the last picture left as
// it is, and refuses what it cannot do with one error.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <vector>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

constexpr int Size = 120;

/// Calls a function whenever an object sends an event.
class Listener
{
public:
  Listener(vtkObject* object, unsigned long event, std::function<void()> function)
    : Function(std::move(function))
    , Observed(object)
    , Tag(object->AddObserver(event, this, &Listener::Call))
  {
  }
  ~Listener() { this->Observed->RemoveObserver(this->Tag); }
  Listener(const Listener&) = delete;
  void operator=(const Listener&) = delete;

private:
  void Call() { this->Function(); }

  std::function<void()> Function;
  vtkObject* Observed;
  unsigned long Tag;
};

void ExpectCold(Scene& scene, const std::string& route, const std::string& what)
{
  ColdWitness cold;
  Expect(scene.Render(Size, Size), what + ": rendered");
  Expect(IsRoute(scene, route),
    what + ": the route is " + scene.Mapper->GetStatistics()->GetRouteAsString() + ", not " +
      route);
  Expect(cold.Draw(scene) && cold.IsIdentical(scene), what + ": not the cold picture");
}

void TestProgress()
{
  for (const bool hasRange : { false, true })
  {
    const std::string what = hasRange ? "progress of a range" : "progress";
    Scene scene(Volumes::Waves(), { 200.0 });
    scene.LookFrom(1.0, 2.0, 0.5);
    if (hasRange)
    {
      scene.Mapper->SetIsomapRange(-1700.0, 1700.0);
    }
    Expect(scene.Render(Size, Size), what + ": rendered");
    std::vector<double> progress;
    const Listener listener(scene.Mapper, vtkCommand::ProgressEvent,
      [&] { progress.push_back(scene.Mapper->GetProgress()); });
    Expect(scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume), what + ": built");
    Expect(!progress.empty() && progress.front() > 0.0 && progress.back() == 1.0,
      what + ": it runs from above 0 to 1");
    for (std::size_t i = 1; i < progress.size(); ++i)
    {
      Expect(progress[i] >= progress[i - 1], what + ": it falls");
    }
    const std::size_t count = progress.size();
    ExpectCold(scene, "Redisplay", what);
    scene.SetIsovalues({ 200.001 });
    ExpectCold(scene, "IsomapLookup", what);
    Expect(progress.size() == count, what + ": frames send ProgressEvent");
  }
}

void TestStoppedAhead()
{
  Scene scene(Volumes::Waves(), { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  ExpectCold(scene, "Cold", "to be stopped");
  EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
  {
    int events = 0;
    const Listener listener(scene.Mapper, vtkCommand::ProgressEvent,
      [&]
      {
        if (++events == 3)
        {
          scene.Mapper->SetAbortExecute(1);
        }
      });
    Expect(!scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume), "stopped, but built");
    Expect(events == 3, "stopped at the third event, but there are " + std::to_string(events));
  }
  scene.Mapper->SetAbortExecute(0);
  Expect(
    scene.Mapper->GetStatistics()->GetIsomapMemory() == 0, "stopped: a part of an isomap is kept");
  Expect(errors.Count == 0, "stopping is no error");
  ExpectCold(scene, "Redisplay", "stopped");
  scene.SetIsovalues({ 230.0 });
  ExpectCold(scene, "IsomapBuild", "after it was stopped");
  Expect(scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume), "not stopped any more");
}

/// The first to tell of progress is the pipeline, before anything is built: it can be stopped
/// there, too, and what is told does not fall.
void TestStoppedAtOnce()
{
  Scene scene(Volumes::Waves(), { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  ExpectCold(scene, "Cold", "to be stopped at once");
  std::vector<double> progress;
  const auto build = [&](bool isStopped)
  {
    progress.clear();
    const Listener listener(scene.Mapper, vtkCommand::ProgressEvent,
      [&]
      {
        progress.push_back(scene.Mapper->GetProgress());
        if (isStopped && progress.size() == 1)
        {
          scene.Mapper->SetAbortExecute(1);
        }
      });
    scene.Mapper->SetIsomapRange(-1700.0, 1700.0);
    scene.Mapper->Modified(); // so that the pipeline has something to do
    return scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume);
  };
  Expect(!build(true), "stopped at once, but built");
  Expect(scene.Mapper->GetStatistics()->GetIsomapMemory() == 0,
    "stopped at once: a part of an isomap is kept");
  Expect(build(false), "after it was stopped at once: not built");
  Expect(std::is_sorted(progress.begin(), progress.end()) && progress.back() == 1.0,
    "progress of a pipeline and a build: it falls");
}

/// A frame that was stopped leaves the picture before; the next one is right.
void ExpectStopped(
  Scene& scene, vtkRenderWindow* window, const std::function<void()>& stop, const std::string& what)
{
  scene.Mapper->ClearCache();
  scene.SetIsovalues({ 200.0 });
  window->Render();
  Expect(IsRoute(scene, "Cold"), what + ": the first frame");
  double position[3], later[3];
  Expect(scene.Mapper->PickPixel(Size / 2, Size / 2, position, nullptr, nullptr), what + ": seen");
  scene.SetIsovalues({ -300.0 });
  {
    const Listener listener(scene.Mapper, vtkCommand::VolumeMapperRenderProgressEvent, stop);
    window->Render();
  }
  Expect(window->GetAbortRender() != 0, what + ": the window was not told to stop");
  Expect(IsRoute(scene, "Cold") && scene.Mapper->GetStatistics()->GetIsomapMemory() == 0,
    what + ": something was made all the same");
  Expect(scene.Mapper->PickPixel(Size / 2, Size / 2, later, nullptr, nullptr) &&
      position[0] == later[0] && position[1] == later[1] && position[2] == later[2],
    what + ": the last picture does not stay");
  scene.SetIsovalues({ 200.0 });
  ExpectCold(scene, "Redisplay", what + ", the picture before");
  scene.SetIsovalues({ -300.0 });
  window->Render();
  Expect(IsRoute(scene, "IsomapBuild"), what + ": the next frame is not built");
  ExpectCold(scene, "Redisplay", what + ", the next frame");
}

void TestStoppedInWindow()
{
  Scene scene(Volumes::Waves(), { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(Size, Size);
  window->AddRenderer(scene.Renderer);
  ExpectStopped(
    scene, window, [&] { window->SetAbortRender(1); }, "stopped by SetAbortRender");

  bool isBuilding = false;
  const Listener listener(window, vtkCommand::AbortCheckEvent,
    [&]
    {
      if (isBuilding)
      {
        isBuilding = false;
        window->SetAbortRender(1);
      }
    });
  ExpectStopped(
    scene, window,
    [&]
    {
      // Windows ask a few times a second only.
      isBuilding = true;
      vtksys::SystemTools::Delay(250);
    },
    "stopped by AbortCheckEvent");
}

void ExpectRefused(
  const std::string& what, const std::function<bool(Scene&)>& build, bool hasFrame = true)
{
  Scene scene(Volumes::Waves(), { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Expect(!hasFrame || scene.Render(Size, Size), what + ": rendered");
  EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
  Expect(!build(scene), what + ": not refused");
  Expect(errors.Count == 1, what + ": " + std::to_string(errors.Count) + " errors");
  Expect(!build(scene) && errors.Count == 1, what + ": said twice");
  scene.Mapper->SetInputData(Volumes::Waves());
  Expect(scene.Render(Size, Size) && scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume),
    what + ": not mended");
  Expect(errors.Count == 1, what + ": an error after it was mended");
}

void TestMistakes()
{
  const auto build = [](Scene& scene)
  { return scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume); };
  ExpectRefused(
    "no renderer", [](Scene& scene) { return scene.Mapper->BuildIsomap(nullptr, scene.Volume); });
  ExpectRefused(
    "no volume", [](Scene& scene) { return scene.Mapper->BuildIsomap(scene.Renderer, nullptr); });
  ExpectRefused("no size", build, false);
  ExpectRefused("no input",
    [&build](Scene& scene)
    {
      scene.Mapper->SetInputData(static_cast<vtkImageData*>(nullptr));
      return build(scene);
    });
}

/// Where there is nothing to build, that is no mistake.
void TestNothingToBuild()
{
  Scene scene(Volumes::Waves(), {});
  scene.LookFrom(1.0, 2.0, 0.5);
  Expect(scene.Render(Size, Size), "no isovalues: rendered");
  EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
  EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume);
  scene.SetIsovalues({ 200.0 });
  scene.Mapper->SetInputData(vtkNew<vtkImageData>().Get());
  Expect(scene.Render(Size, Size), "no samples: rendered");
  Expect(warnings.Count == 1, "no samples: why the picture is empty is not said once");
  scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume);
  Expect(errors.Count == 0, "nothing to build: an error");
  Expect(warnings.Count == 1, "nothing to build: a warning");
  ExpectCold(scene, "Redisplay", "nothing to build");
}

}

int TestIsomapBuild(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestProgress();
  TestStoppedAhead();
  TestStoppedAtOnce();
  TestStoppedInWindow();
  TestMistakes();
  TestNothingToBuild();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
