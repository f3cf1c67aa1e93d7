// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ExplorerWindow.h"

#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkTimerLog.h>
#include <vtkWindowToImageFilter.h>

#include <cstdio>
#include <exception>

namespace
{

constexpr double ProgressAfter = 0.25; // seconds: what is over sooner needs no bar
constexpr double ProgressEvery = 0.08; // seconds

}

// The view keeps the last picture while panels are drawn over it.
struct ExplorerWindow::Work
{
  explicit Work(ExplorerWindow& window)
    : At(window)
  {
    this->At.Busy = true;
    this->At.IsStopped = false;
    this->At.WorkBegan = vtkTimerLog::GetUniversalTime();
    this->At.Data.View.Renderer->DrawOff();
  }
  ~Work()
  {
    this->At.Busy = false;
    this->At.Parts.Progress.SetVisible(false);
    this->At.Data.View.Renderer->DrawOn();
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  ExplorerWindow& At;
};

ExplorerWindow::ExplorerWindow(const Options& options)
  : SessionFile(options.SessionFile)
  , Data(options.From, options.Up)
  , Parts(this->Shown, this->Data)
  , Output(options.OutputDirectory)
  , Log(options.Log)
{
  this->Shown->SetWindowName("vtkTemporalCoherence Explorer");
  this->Shown->SetMultiSamples(0); // the picture is ray cast; samples would only cost
  this->Shown->SetSize(options.Width, options.Height);
  this->Mouse->SetHands(this);
  this->Events->SetInteractorStyle(this->Mouse);
  this->Events->SetRenderWindow(this->Shown);
  this->Data.SetProgress(
    [this](const std::string& what, double share) { return this->OnProgress(what, share); });
  this->ObserveFrames();
}

ExplorerWindow::~ExplorerWindow() = default;

void ExplorerWindow::Render()
{
  this->Shown->Render();
}

vtkSmartPointer<vtkImageData> ExplorerWindow::PictureOfWindow()
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Shown);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  return grab->GetOutput();
}

void ExplorerWindow::Open(const Session& session)
{
  this->Parts.Arrange(); // the view's shape says how large the volume can be
  {
    const Work work(*this);
    this->Data.Open(session);
  }
  this->Parts.Statistics.SetVolume(this->Data.Name(), this->Data.Description());
  this->Parts.Invalidate();
  this->ArePlacesKnown = false; // meshes have one switch more
  this->Log.Event("opened", this->Data.Name());
}

// Another array or time step of the file.
void ExplorerWindow::ShowOther(const std::function<void()>& turn)
{
  this->Try(
    [&]
    {
      {
        const Work work(*this);
        turn();
      }
      this->Parts.Statistics.SetVolume(this->Data.Name(), this->Data.Description());
      this->Parts.Invalidate();
      this->Log.Event("shown", this->Data.Description());
    });
}

void ExplorerWindow::Run()
{
  this->Render();
  this->Events->Start();
  if (this->Output.IsRecording())
  {
    this->Say(this->Output.Stop());
  }
}

void ExplorerWindow::Say(const std::string& said, bool isWarning)
{
  const std::string sentence = Printable(said);
  this->Parts.Say(sentence, isWarning);
  this->Log.Said(sentence);
  std::fprintf(
    isWarning ? stderr : stdout, "%s%s\n", isWarning ? "Explorer: " : "", sentence.c_str());
  std::fflush(stdout);
}

void ExplorerWindow::Try(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const std::exception& failure)
  {
    this->Say(SentenceOf(failure), true);
  }
  this->Parts.Switches.Invalidate();
  this->Parts.Isovalue.Invalidate();
  this->Render();
}

void ExplorerWindow::OnFrameBegin()
{
  this->FrameBegan = vtkTimerLog::GetUniversalTime();
  if (this->Parts.Arrange() || !this->ArePlacesKnown)
  {
    this->LogPlaces();
    this->ArePlacesKnown = true;
  }
}

void ExplorerWindow::OnFrameEnd()
{
  if (this->Busy || !this->Data.State().Isovalue)
  {
    return;
  }
  const double ms = 1000.0 * (vtkTimerLog::GetUniversalTime() - this->FrameBegan);
  this->Parts.Statistics.SetWindowMs(ms);
  this->Log.Frame(this->Data.View.Facts(), this->Data.Isovalue(), ms);
  this->Record();
}

void ExplorerWindow::Record()
{
  if (!this->Output.IsRecording())
  {
    return;
  }
  try
  {
    this->Output.Add(this->Data.View.LastFrame());
  }
  catch (const UserError& mistake)
  {
    this->Output.Stop();
    this->Parts.Switches.SetRecording(false);
    this->Say(mistake.what(), true);
  }
}

bool ExplorerWindow::OnProgress(const std::string& what, double share)
{
  const double now = vtkTimerLog::GetUniversalTime();
  if (now - this->WorkBegan > ProgressAfter && now - this->ProgressShown > ProgressEvery)
  {
    this->ProgressShown = now;
    this->Parts.Progress.Show(what, share);
    this->Render();
    this->Log.Event("progress", std::to_string(share));
  }
  if (this->Events->GetInitialized())
  {
    this->Events->ProcessEvents(); // Escape may be among them
  }
  return !this->IsStopped && !this->Events->GetDone();
}

void ExplorerWindow::SetIsovalueAt(int x)
{
  this->Data.SetIsovalue(this->Parts.Isovalue.IsovalueAt(x));
  this->Parts.Isovalue.Invalidate();
  this->Render();
}

void ExplorerWindow::LogPlaces()
{
  const auto tell = [this](const std::string& name, int x, int y) { this->Log.Place(name, x, y); };
  const Rect plot = this->Parts.Isovalue.PlotInWindow();
  tell("isovalue-least", plot.X, plot.Y + plot.Height / 2);
  tell("isovalue-greatest", plot.Right() - 1, plot.Y + plot.Height / 2);
  this->Parts.Switches.ForEachPlace(tell);
}

void ExplorerWindow::Turn(Choose what, int steps)
{
  this->Data.Turn(what, steps);
  this->Log.Event(ChoiceOf(what).Name, this->Data.State().Choices.TextOf(what));
  this->Parts.Invalidate();
  this->Render();
}

void ExplorerWindow::OpenPath(const std::string& path)
{
  this->Parts.Files.SetVisible(false);
  this->Try(
    [&]
    {
      if (IsSessionName(path))
      {
        this->Open(ReadSession(path));
        return;
      }
      // Another volume is looked at in the same way.
      Session session = this->Data.State();
      VolumeSource source;
      source.Path = path;
      source.Spheres = session.Source.Spheres;
      session.Source = source;
      session.Isovalue.reset();
      session.Camera.reset();
      this->Open(session);
    });
}

void ExplorerWindow::BuildIsomap()
{
  bool isBuilt = false;
  {
    const Work work(*this);
    isBuilt = this->Data.BuildIsomap();
  }
  this->Say(isBuilt     ? "The isomap of this view is built: any isovalue is looked up."
      : this->IsStopped ? "The isomap was stopped; the parts that are needed are built as you drag."
                        : "There can be no isomap here; isovalues are found without it.",
    !isBuilt && !this->IsStopped);
}

void ExplorerWindow::PrepareDrag()
{
  if (this->Data.WantsIsomapAhead())
  {
    const Work work(*this);
    this->Data.BuildIsomap();
  }
}

void ExplorerWindow::SavePicture()
{
  const int scale = std::stoi(this->Data.State().Choices.TextOf(Choose::Scale));
  this->Say("Saved " + this->Output.Save(this->Data.View.Picture(scale)));
}

void ExplorerWindow::ToggleRecording()
{
  if (this->Output.IsRecording())
  {
    this->Say(this->Output.Stop());
  }
  else
  {
    this->Output.Start(this->Data.State().Choices.TextOf(Choose::Film));
    this->Say("Recording every frame");
  }
  this->Parts.Switches.SetRecording(this->Output.IsRecording());
}
