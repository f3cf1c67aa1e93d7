// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Frames report progress and can be stopped. The last picture stays, and the next frame is as if
// nothing had been stopped.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"

#include <vtkCommand.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkRenderWindow.h>
#include <vtkTestErrorObserver.h>
#include <vtksys/SystemTools.hxx>

#include <array>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{

constexpr int Size = 300; // enough for several parts

/// Writes down the events of frames, and may do something at each report and each start.
class Recorder
{
public:
  explicit Recorder(vtkTemporalCoherenceVolumeMapper* mapper, std::function<void()> atReport = {},
    std::function<void()> atStart = {})
    : Mapper(mapper)
    , AtReport(std::move(atReport))
    , AtStart(std::move(atStart))
  {
    for (const unsigned long event : { vtkCommand::VolumeMapperRenderStartEvent,
           vtkCommand::VolumeMapperRenderProgressEvent, vtkCommand::VolumeMapperRenderEndEvent })
    {
      this->Tags.push_back(mapper->AddObserver(event, this, &Recorder::Add));
    }
  }
  ~Recorder()
  {
    for (const unsigned long tag : this->Tags)
    {
      this->Mapper->RemoveObserver(tag);
    }
  }
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// True if one frame began, told progress that never falls, and ended.
  bool IsOneFrame() const
  {
    return this->Starts == 1 && this->Ends == 1 && this->IsInOrder && !this->Progress.empty();
  }

  int Starts = 0, Ends = 0;
  bool IsInOrder = true;
  bool IsMade = false; ///< as the last end tells
  std::vector<double> Progress;

private:
  void Add(vtkObject*, unsigned long event, void* data)
  {
    if (event == vtkCommand::VolumeMapperRenderStartEvent)
    {
      this->IsInOrder &= this->Starts++ == this->Ends;
      if (this->AtStart)
      {
        this->AtStart();
      }
    }
    else if (event == vtkCommand::VolumeMapperRenderEndEvent)
    {
      this->IsInOrder &= ++this->Ends == this->Starts;
      this->IsMade = *static_cast<bool*>(data);
    }
    else
    {
      const double progress = *static_cast<double*>(data);
      const double last = this->Progress.empty() ? 0.0 : this->Progress.back();
      this->IsInOrder &= this->Starts == this->Ends + 1 && last <= progress && progress <= 1.0;
      this->Progress.push_back(progress);
      if (this->AtReport)
      {
        this->AtReport();
      }
    }
  }

  vtkTemporalCoherenceVolumeMapper* Mapper;
  std::function<void()> AtReport, AtStart;
  std::vector<unsigned long> Tags;
};

/// A scene in a window, and changes that make frames of every route that traces.
struct Stage : Scene
{
  Stage()
    : Scene(Volumes::Waves(), { 200.0 })
  {
    this->LookFrom(1.0, 2.0, 0.5);
    this->Mapper->SetReuseAccuracyToPaper(); // or a moved camera is cold
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Size, Size);
    this->Window->AddRenderer(this->Renderer);
  }
  void Turn()
  {
    this->Renderer->GetActiveCamera()->Azimuth(1.0);
    this->Renderer->ResetCameraClippingRange();
  }
  vtkNew<vtkRenderWindow> Window;
};

struct Step
{
  std::string Route;
  std::function<void(Stage&)> Change;
};

std::vector<Step> Steps()
{
  return { { "Cold", [](Stage& stage) { stage.Volume->RotateZ(5.0); } },
    { "ImageCache", [](Stage& stage) { stage.Turn(); } },
    { "IsomapBuild",
      [](Stage& stage)
      {
        stage.Mapper->SetIsomapRange(-320.0, -280.0);
        stage.SetIsovalues({ -300.0 });
      } },
    { "IsomapLookup", [](Stage& stage) { stage.SetIsovalues({ -298.0 }); } },
    { "Reshade", [](Stage& stage) { stage.Volume->GetProperty()->SetAmbient(0.3); } },
    { "Cold",
      [](Stage& stage)
      {
        stage.Mapper->IsomapOff();
        stage.SetIsovalues({ 100.0 });
      } } };
}

/// The picture as it is now, and the last frame: they are the same if nothing was made in between.
bool IsLastFrame(Stage& stage, vtkImageData* color, vtkImageData* depth)
{
  vtkNew<vtkImageData> colorNow, depthNow;
  return stage.GetLastFrame(colorNow, depthNow) && AreIdentical(colorNow, color) &&
    AreIdentical(depthNow, depth);
}

void TestEvents()
{
  Stage stage;
  stage.Window->Render();
  for (const Step& step : Steps())
  {
    step.Change(stage);
    const Recorder recorder(stage.Mapper);
    stage.Window->Render();
    Expect(IsRoute(stage, step.Route),
      step.Route + ": taken, but it was " + stage.Mapper->GetStatistics()->GetRouteAsString());
    Expect(recorder.IsOneFrame() && recorder.Progress.back() == 1.0 && recorder.IsMade,
      step.Route + ": start, progress, end");
    Expect(recorder.Progress.size() > 5,
      step.Route + ": in parts, " + std::to_string(recorder.Progress.size()));
    stage.Window->Render(); // refined, where it is not exact
  }
  const Recorder again(stage.Mapper);
  stage.Window->Render();
  Expect(IsRoute(stage, "Redisplay") && again.IsOneFrame() && again.IsMade,
    "a picture that is shown again");
  const Recorder image(stage.Mapper);
  stage.Turn();
  Expect(
    stage.Render(Size, Size) && image.IsOneFrame() && image.IsMade, "an image is a frame, too");
  const Recorder failed(stage.Mapper);
  EventCounter errors(stage.Mapper, vtkCommand::ErrorEvent);
  stage.Volume->SetScale(0.0, 1.0, 1.0);
  stage.Window->Render();
  Expect(errors.Count == 1 && failed.Ends == 1 && !failed.IsMade, "one that fails ends, too");
}

/// Observers and parts make no difference to the picture.
void TestSamePicture()
{
  Stage heard, alone;
  const Recorder recorder(heard.Mapper);
  for (const Step& step : Steps())
  {
    step.Change(heard);
    step.Change(alone);
    Expect(heard.Render(Size, Size) && alone.Render(Size, Size), step.Route + ": rendered");
    Expect(AreIdentical(heard.Color, alone.Color) && AreIdentical(heard.Depth, alone.Depth) &&
        heard.Mapper->GetStatistics()->GetNumberOfFieldSamples() ==
          alone.Mapper->GetStatistics()->GetNumberOfFieldSamples() &&
        heard.Mapper->GetStatistics()->GetNumberOfDefiniteMisses() ==
          alone.Mapper->GetStatistics()->GetNumberOfDefiniteMisses(),
      step.Route + ": the same picture in parts");
  }
}

/// Stop a frame of each route at each of some reports; what is made later is what would have been.
void TestStopped()
{
  for (const std::size_t stopAt : std::array<std::size_t, 4>{ 0, 1, 3, 6 })
  {
    Stage stage, alone;
    EventCounter errors(stage.Mapper, vtkCommand::ErrorEvent);
    stage.Window->Render();
    Expect(alone.Render(Size, Size), "rendered");
    for (const Step& step : Steps())
    {
      const std::string what = step.Route + ", stopped at " + std::to_string(stopAt);
      vtkNew<vtkImageData> color, depth;
      stage.GetLastFrame(color, depth);
      const std::string route = stage.Mapper->GetStatistics()->GetRouteAsString();
      const vtkIdType samples = stage.Mapper->GetStatistics()->GetNumberOfFieldSamples();
      step.Change(stage);
      {
        std::size_t reports = 0;
        const Recorder recorder(stage.Mapper,
          [&]
          {
            if (reports++ == stopAt)
            {
              stage.Window->SetAbortRender(1);
            }
          });
        stage.Window->Render();
        Expect(stage.Window->GetAbortRender() != 0 && recorder.Progress.size() == stopAt + 1,
          what + ": stopped there");
        Expect(recorder.IsOneFrame() && recorder.Progress.back() < 1.0 && !recorder.IsMade,
          what + ": events");
      }
      Expect(IsLastFrame(stage, color, depth) && IsRoute(stage, route) &&
          stage.Mapper->GetStatistics()->GetNumberOfFieldSamples() == samples,
        what + ": the last frame and what is told of it stay");

      // The next frame, and one of an image on the same machine that was never stopped.
      step.Change(alone);
      Expect(alone.Render(Size, Size), what + ": rendered");
      stage.Window->Render();
      Expect(IsRoute(stage, step.Route) ||
          (step.Route == "IsomapBuild" && IsRoute(stage, "IsomapLookup")),
        what + ": the next frame takes the route, but it was " +
          stage.Mapper->GetStatistics()->GetRouteAsString());
      Expect(IsLastFrame(stage, alone.Color, alone.Depth), what + ": the next frame is right");
    }
    Expect(errors.Count == 0, "stopping is no error");
  }
}

/// The window's own question, which it passes on a few times a second.
void TestAbortCheckEvent()
{
  Stage stage;
  stage.Window->Render();
  vtkNew<vtkImageData> color, depth;
  stage.GetLastFrame(color, depth);
  stage.Volume->RotateZ(5.0);
  struct Answer
  {
    vtkRenderWindow* Window;
    void Stop() { this->Window->SetAbortRender(1); }
  } answer{ stage.Window };
  vtksys::SystemTools::Delay(250);
  const unsigned long tag =
    stage.Window->AddObserver(vtkCommand::AbortCheckEvent, &answer, &Answer::Stop);
  stage.Window->Render();
  Expect(stage.Window->GetAbortRender() != 0 && IsLastFrame(stage, color, depth), "stopped");
  stage.Window->RemoveObserver(tag);
  stage.Window->Render();
  Expect(IsRoute(stage, "Cold") && !IsLastFrame(stage, color, depth), "made after that");
  ColdWitness witness;
  Expect(stage.Render(Size, Size) && witness.Draw(stage) && witness.IsIdentical(stage), "right");
}

/// A window that was told to stop keeps its flag; images have nothing to do with it, and are
/// stopped by their observers.
void TestImages()
{
  Stage stage;
  stage.Window->Render();
  stage.Window->SetAbortRender(1);
  stage.Volume->RotateZ(5.0);
  Expect(stage.Render(Size, Size) && IsRoute(stage, "Cold"), "not stopped by the window");

  vtkNew<vtkImageData> color, depth;
  color->DeepCopy(stage.Color);
  depth->DeepCopy(stage.Depth);
  stage.Volume->RotateZ(5.0);
  {
    const Recorder recorder(stage.Mapper, [&] { stage.Mapper->SetAbortExecute(1); });
    Expect(!stage.Render(Size, Size) && !recorder.IsMade, "stopped by SetAbortExecute");
  }
  Expect(AreIdentical(stage.Color, color) && AreIdentical(stage.Depth, depth) &&
      IsLastFrame(stage, color, depth),
    "images are left alone");
  Expect(stage.Render(Size, Size) && !AreIdentical(stage.Color, color), "made after that");
}

/// What observers may not do is refused.
void TestBusy()
{
  Stage stage;
  vtkNew<vtkTest::ErrorObserver> observer;
  stage.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  const double p1[3] = { -9.0, 0.0, 0.0 }, p2[3] = { 9.0, 0.0, 0.0 };
  double t;
  const std::vector<std::pair<std::string, std::function<bool()>>> calls = {
    { "ClearCache",
      [&]
      {
        stage.Mapper->ClearCache();
        return false;
      } },
    { "MakeImage", [&] { return stage.Render(10, 10); } },
    { "BuildIsomap", [&] { return stage.Mapper->BuildIsomap(stage.Renderer, stage.Volume); } },
    { "IntersectWithLine",
      [&] {
        return stage.Mapper->IntersectWithLine(stage.Volume, p1, p2, t, nullptr, nullptr, nullptr);
      } },
    { "Render",
      [&]
      {
        stage.Mapper->Render(stage.Renderer, stage.Volume);
        return false;
      } },
  };
  for (const auto& [name, call] : calls)
  {
    for (const bool isAtStart : { false, true })
    {
      stage.Turn();
      observer->Clear();
      {
        bool isDone = false;
        const auto& callNow = call;
        const std::function<void()> action = [&] { isDone |= callNow(); };
        const Recorder recorder(
          stage.Mapper, isAtStart ? nullptr : action, isAtStart ? action : nullptr);
        stage.Window->Render();
        Expect(!isDone, name + ": refused");
      }
      Expect(observer->GetError() &&
          observer->GetErrorMessage().find(name + " must not be called") != std::string::npos,
        name + ": said so");
      ColdWitness witness;
      Expect(stage.Render(Size, Size) && witness.Draw(stage) && witness.CountDifferent(stage) < 10,
        name + ": the frame is right");
    }
  }
}

}

int TestAbort(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestEvents();
  TestSamePicture();
  TestStopped();
  TestAbortCheckEvent();
  TestImages();
  TestBusy();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
