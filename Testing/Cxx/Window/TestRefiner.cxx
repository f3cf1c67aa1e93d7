// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkTemporalCoherenceRefiner renders a window until all its pictures are final. It stops at an
// interaction and goes on after it. It may die before or after all that it knows.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceRefiner.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTestErrorObserver.h>
#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <functional>
#include <set>
#include <string>

namespace
{

constexpr int Size = 64;
constexpr int Enough = 60; ///< frames until light is final
constexpr double Interactive = 15.0, Still = 1e-4;

/// An interactor whose timers fire when the test wants it.
class HandInteractor : public vtkRenderWindowInteractor
{
public:
  static HandInteractor* New();
  vtkTypeMacro(HandInteractor, vtkRenderWindowInteractor);

  int Pending() const { return static_cast<int>(this->Timers.size()); }

  void Fire()
  {
    const std::set<int> now = this->Timers;
    for (const int timer : now)
    {
      int id = this->GetVTKTimerId(timer);
      if (id != 0)
      {
        this->DestroyTimer(id); // all are one-shot timers
        this->InvokeEvent(vtkCommand::TimerEvent, &id);
      }
    }
  }

protected:
  int InternalCreateTimer(int, int type, unsigned long) override
  {
    Expect(type == OneShotTimer, "timers fire once");
    this->Timers.insert(++this->Last);
    return this->Last;
  }
  int InternalDestroyTimer(int timer) override { return this->Timers.erase(timer) == 1; }

private:
  std::set<int> Timers;
  int Last = 0;
};
vtkStandardNewMacro(HandInteractor);

/// Spheres with ambient occlusion in a renderer of a window.
struct LitSpheres : Scene
{
  explicit LitSpheres(vtkRenderWindow* window)
    : Scene(Volumes::FourSpheres(24), { 100.0 })
  {
    this->LookFrom(1.0, 2.0, 0.5);
    this->Volume->GetProperty()->ShadeOn();
    this->Mapper->AmbientOcclusionOn();
    this->Renderer->AddVolume(this->Volume);
    window->AddRenderer(this->Renderer);
  }
  void Turn() { this->Renderer->GetActiveCamera()->Azimuth(1.0); }
};

/// A window with an interactor and a refiner.
struct Stage
{
  Stage()
  {
    this->Window->SetMultiSamples(0);
    this->Window->OffScreenRenderingOn();
    this->Window->SetSize(Size, Size);
    this->Interactor->SetRenderWindow(this->Window);
    this->Refiner->SetInteractor(this->Interactor);
    this->Interactor->Initialize();
  }

  /// Fire timers until none is pending.
  /// \return the number of frames
  int Run()
  {
    const EventCounter frames(this->Window, vtkCommand::EndEvent);
    while (this->Interactor->Pending() > 0 && frames.Count < 2 * Enough)
    {
      this->Interactor->Fire();
    }
    return frames.Count;
  }

  vtkSmartPointer<vtkRenderWindow> Window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkSmartPointer<HandInteractor> Interactor = vtkSmartPointer<HandInteractor>::New();
  vtkSmartPointer<vtkTemporalCoherenceRefiner> Refiner =
    vtkSmartPointer<vtkTemporalCoherenceRefiner>::New();
};

void TestUntilFinal()
{
  Stage stage;
  LitSpheres scene(stage.Window);
  EventCounter told(stage.Refiner, vtkCommand::ProgressEvent);
  EventCounter pictures(scene.Mapper, vtkTemporalCoherenceVolumeMapper::FrameProgressEvent);
  stage.Window->Render();
  const double first = stage.Refiner->GetProgress();
  Expect(first >= 0.0 && first < 1.0 && first == scene.Mapper->GetFrameProgress() &&
      !scene.Mapper->GetFrameIsFinal(),
    "the first frame is not final: " + std::to_string(first));
  Expect(stage.Interactor->Pending() == 1, "one timer");
  const int frames = stage.Run();
  Expect(frames > 8 && frames < Enough, std::to_string(frames) + " frames");
  Expect(scene.Mapper->GetFrameIsFinal() && scene.Mapper->GetFrameProgress() == 1.0 &&
      stage.Refiner->GetProgress() == 1.0,
    "then it is final");
  Expect(told.Count == frames + 1 && pictures.Count == frames + 1, "progress of each frame");
  stage.Window->Render();
  Expect(
    stage.Interactor->Pending() == 0 && told.Count == frames + 1, "then nothing is to be done");
  scene.Mapper->AmbientOcclusionOff();
  scene.Turn();
  stage.Window->Render();
  Expect(stage.Interactor->Pending() == 0, "nothing to be done without occlusion");
}

void TestInteraction()
{
  Stage stage;
  LitSpheres scene(stage.Window);
  stage.Window->Render();
  stage.Window->SetDesiredUpdateRate(Interactive); // as styles do when an interaction begins
  Expect(stage.Run() == 0, "a timer that was pending renders nothing");
  scene.Turn();
  stage.Window->Render();
  Expect(stage.Interactor->Pending() == 0 && stage.Refiner->GetProgress() < 1.0,
    "an interactive frame starts nothing");
  stage.Window->SetDesiredUpdateRate(Still);
  stage.Window->Render();
  Expect(stage.Run() > 4 && scene.Mapper->GetFrameIsFinal(), "the still frame starts it again");

  scene.Turn();
  stage.Window->Render();
  stage.Refiner->EnabledOff();
  Expect(stage.Interactor->Pending() == 0, "switched off: no timer");
  stage.Window->Render();
  Expect(stage.Interactor->Pending() == 0, "switched off: still none");
  stage.Refiner->EnabledOn();
  Expect(stage.Interactor->Pending() == 1 && stage.Run() > 0 && scene.Mapper->GetFrameIsFinal(),
    "switched on: it goes on");
}

/// The least progress counts, whatever the order; a mapper shown twice has two pictures.
void TestSeveral()
{
  Stage stage;
  LitSpheres one(stage.Window), other(stage.Window);
  other.Volume->SetPosition(0.0, 0.0, 10.0);
  one.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  other.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  one.Renderer->AddVolume(other.Volume);
  one.Mapper->SetAmbientOcclusionRays(64);
  stage.Window->Render();
  stage.Run();
  Expect(one.Mapper->GetFrameIsFinal() && other.Mapper->GetFrameIsFinal() &&
      stage.Refiner->GetProgress() == 1.0,
    "all are final");
  one.Turn();
  one.SetIsovalues({ 90.0 });
  stage.Window->Render();
  Expect(stage.Refiner->GetProgress() == one.Mapper->GetFrameProgress() &&
      stage.Refiner->GetProgress() < 1.0 && stage.Interactor->Pending() == 1,
    "one of them is not");
}

/// A frame that is stopped leaves the picture as it was, and is made again.
void TestStopped()
{
  Stage stage;
  LitSpheres scene(stage.Window);
  stage.Window->SetSize(300, 300); // enough for several parts
  stage.Window->Render();
  vtkNew<vtkImageData> before, depth, after;
  scene.GetLastFrame(before, depth);
  const double progress = stage.Refiner->GetProgress();
  struct Answer
  {
    vtkRenderWindow* Window;
    void Stop() { this->Window->SetAbortRender(1); }
  } answer{ stage.Window };
  const unsigned long tag =
    stage.Refiner->AddObserver(vtkCommand::AbortCheckEvent, &answer, &Answer::Stop);
  vtksys::SystemTools::Delay(250); // windows ask a few times a second
  stage.Interactor->Fire();
  scene.GetLastFrame(after, depth);
  Expect(stage.Window->GetAbortRender() != 0 && AreIdentical(before, after) &&
      stage.Refiner->GetProgress() == progress,
    "stopped, and the picture stays");
  Expect(stage.Interactor->Pending() == 1, "another frame is to come");
  stage.Refiner->RemoveObserver(tag);
  Expect(stage.Run() > 4 && scene.Mapper->GetFrameIsFinal(), "it goes on");
}

/// Without an event loop, or with one that has not begun, frames are made on demand.
void TestOnDemand()
{
  Stage stage;
  LitSpheres scene(stage.Window);
  vtkNew<HandInteractor> idle;
  idle->SetRenderWindow(stage.Window);
  stage.Window->SetInteractor(stage.Interactor); // rendering initialises it, and not the other one
  stage.Refiner->SetInteractor(idle);
  stage.Window->Render();
  Expect(
    idle->Pending() == 0 && stage.Interactor->Pending() == 0 && stage.Refiner->GetProgress() < 1.0,
    "no timer of an interactor that is not initialised");
  idle->Initialize(); // which renders
  Expect(idle->Pending() == 1, "a timer once it is");
  stage.Window->SetInteractor(nullptr);
  stage.Refiner->SetRenderWindow(stage.Window);
  stage.Window->Render();
  Expect(idle->Pending() == 0 && !stage.Refiner->GetInteractor() &&
      stage.Refiner->GetRenderWindow() == stage.Window,
    "a window alone");
  stage.Window->SetDesiredUpdateRate(Interactive);
  scene.Turn();
  Expect(stage.Refiner->Refine() && scene.Mapper->GetFrameIsFinal(), "refined on demand");
  Expect(stage.Window->GetDesiredUpdateRate() == Interactive && stage.Refiner->GetEnabled(),
    "nothing else has changed");
  EventCounter frames(stage.Window, vtkCommand::EndEvent);
  Expect(stage.Refiner->Refine() && frames.Count == 1, "a final picture is one frame");

  vtkNew<vtkTest::ErrorObserver> errors;
  stage.Refiner->AddObserver(vtkCommand::ErrorEvent, errors);
  stage.Refiner->SetRenderWindow(nullptr);
  Expect(!stage.Refiner->Refine() && errors->GetError(), "there must be a window");
}

/// A refiner may be given another window, with or without its interactor.
void TestOtherWindow()
{
  Stage stage, other;
  LitSpheres scene(stage.Window), inOther(other.Window);
  stage.Window->Render();
  Expect(stage.Interactor->Pending() == 1, "a timer for the window");
  other.Refiner->SetInteractor(nullptr);
  stage.Refiner->SetRenderWindow(other.Window);
  Expect(
    stage.Interactor->Pending() == 0 && stage.Refiner->GetProgress() == 1.0, "that one is let go");
  stage.Window->Render();
  Expect(stage.Interactor->Pending() == 0, "and no more heard");
  other.Window->Render();
  Expect(other.Run() > 8 && inOther.Mapper->GetFrameIsFinal() && !scene.Mapper->GetFrameIsFinal(),
    "the other one is refined");
}

/// A window may get another interactor while a timer waits.
void TestOtherInteractor()
{
  Stage stage;
  LitSpheres scene(stage.Window);
  stage.Refiner->SetRenderWindow(stage.Window);
  stage.Window->Render();
  Expect(stage.Interactor->Pending() == 1, "a timer of the window's interactor");
  vtkNew<HandInteractor> next;
  next->SetRenderWindow(stage.Window);
  next->Initialize();
  stage.Window->Render();
  Expect(stage.Interactor->Pending() == 0 && next->Pending() == 1, "then of the next one");
}

/// Where frames bring nothing, as for want of memory, refinement ends.
void TestVain()
{
  Stage stage;
  vtkNew<vtkCallbackCommand> half;
  half->SetClientData(stage.Window);
  half->SetCallback(
    [](vtkObject*, unsigned long, void* window, void*)
    {
      double progress = 0.5;
      static_cast<vtkRenderWindow*>(window)->InvokeEvent(
        vtkTemporalCoherenceVolumeMapper::FrameProgressEvent, &progress);
    });
  vtkNew<vtkRenderer> renderer;
  stage.Window->AddRenderer(renderer);
  renderer->AddObserver(vtkCommand::EndEvent, half);
  stage.Window->Render();
  const int frames = stage.Run();
  Expect(frames > 0 && frames < 10, "after some frames it ends: " + std::to_string(frames));
  Expect(!stage.Refiner->Refine(), "on demand, too");
  stage.Window->Render();
  Expect(stage.Interactor->Pending() == 1, "another frame begins anew");
}

/// Whatever dies first.
void TestDeaths()
{
  const std::function<void(Stage&, LitSpheres*&)> deaths[] = {
    [](Stage& stage, LitSpheres*&) { stage.Refiner = nullptr; },
    [](Stage& stage, LitSpheres*& scene)
    {
      stage.Window->RemoveRenderer(scene->Renderer);
      delete scene;
      scene = nullptr;
    },
    [](Stage& stage, LitSpheres*&)
    {
      stage.Interactor->SetRenderWindow(nullptr);
      stage.Window = nullptr;
    },
    [](Stage& stage, LitSpheres*&)
    {
      stage.Window->SetInteractor(nullptr);
      stage.Interactor = nullptr;
    },
  };
  for (const auto& death : deaths)
  {
    Stage stage;
    auto* scene = new LitSpheres(stage.Window);
    stage.Window->Render();
    stage.Interactor->Fire();
    Expect(stage.Interactor->Pending() == 1, "frames are made");
    death(stage, scene);
    if (stage.Interactor)
    {
      stage.Interactor->Fire();
    }
    if (stage.Window)
    {
      stage.Window->Render();
    }
    delete scene;
  }

  // Those that hear of its progress let go of it.
  Stage stage;
  LitSpheres scene(stage.Window);
  vtkNew<vtkCallbackCommand> release;
  release->SetClientData(&stage);
  release->SetCallback(
    [](vtkObject*, unsigned long, void* of, void*) { static_cast<Stage*>(of)->Refiner = nullptr; });
  stage.Refiner->AddObserver(vtkCommand::ProgressEvent, release);
  stage.Window->Render();
  Expect(!stage.Refiner && stage.Interactor->Pending() == 0, "no timer of a dead refiner");
  stage.Window->Render();
}

}

int TestRefiner(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestUntilFinal();
  TestInteraction();
  TestSeveral();
  TestStopped();
  TestOnDemand();
  TestOtherWindow();
  TestOtherInteractor();
  TestVain();
  TestDeaths();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
