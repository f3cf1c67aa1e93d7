// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Work/Workbench.h"

#include "Program/UserError.h"

#include <vtkCallbackCommand.h>
#include <vtkRenderWindow.h>
#include <vtkTimerLog.h>

#include <exception>
#include <memory>
#include <utility>

namespace
{

constexpr double ProgressStep = 0.01; // of the whole
constexpr int SettleAfter = 100;      // ms: what is drawn in each frame delays it

constexpr double RateOfDrags = 15.0; // frames a second
constexpr double RateOfStills = 1e-4;

class Change : public QUndoCommand
{
public:
  Change(Workbench& bench, const QString& name, int gesture, const Look& after)
    : QUndoCommand(name)
    , Bench(bench)
    , Gesture(gesture)
    , Before(bench.Data.Settings())
    , After(after)
  {
  }
  int id() const override { return this->Gesture; }
  void undo() override { this->Bench.Show(this->Before); }
  void redo() override { this->Bench.Show(this->After); }
  bool mergeWith(const QUndoCommand* other) override
  {
    const bool isSame = other->text() == this->text();
    this->After = isSame ? static_cast<const Change*>(other)->After : this->After;
    return isSame;
  }

private:
  Workbench& Bench;
  int Gesture;
  Look Before, After;
};

// The last line of a message of VTK's, which is the sentence itself.
std::string SentenceOfVtk(const std::string& text)
{
  const std::size_t begin = text.find("): ");
  const std::string sentence = begin == std::string::npos ? text : text.substr(begin + 3);
  return sentence.substr(0, sentence.find_last_not_of("\n ") + 1);
}

template <typename Action>
void Observe(vtkObject* subject, unsigned long event, Action action)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Action(action));
  command->SetClientDataDeleteCallback([](void* data) { delete static_cast<Action*>(data); });
  command->SetCallback([](vtkObject*, unsigned long, void* data, void* message)
    { (*static_cast<Action*>(data))(static_cast<const char*>(message)); });
  subject->AddObserver(event, command);
}

}

Workbench::Workbench(const Options& options)
  : Chosen(options)
  , Data(options.From, options.Up)
  , Output(options.OutputDirectory)
  , Log(options.Log)
  , SessionFile(options.SessionFile)
{
  this->ListenToMapper();
  this->Settling.setSingleShot(true);
  QObject::connect(&this->Settling, &QTimer::timeout, this, &Workbench::Settled);
  QObject::connect(this, &Workbench::Changed, this,
    [this]
    {
      if (!this->Settling.isActive())
      {
        this->Settling.start(SettleAfter);
      }
    });
}

Workbench::~Workbench()
{
  this->IsStopped = true;
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void Workbench::SetWindow(vtkRenderWindow* window)
{
  this->Window = window;
  window->AddRenderer(this->Data.View.Renderer);
  Observe(window, vtkCommand::StartEvent,
    [this](const char*)
    {
      this->FrameBegan = vtkTimerLog::GetUniversalTime();
      this->IsDue = false;
    });
  Observe(window, vtkCommand::EndEvent, [this](const char*) { this->OnFrameEnd(); });
}

// With an observer, VTK writes nothing on the terminal itself.
void Workbench::ListenToMapper()
{
  for (const unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
  {
    Observe(this->Data.View.Mapper, event,
      [this](const char* message)
      {
        const std::string sentence = SentenceOfVtk(message ? message : "");
        QMetaObject::invokeMethod(this, [this, sentence] { this->Say(sentence, true); });
      });
  }
}

void Workbench::RenderSoon()
{
  if (!this->IsDue)
  {
    this->IsDue = true;
    QTimer::singleShot(0, this,
      [this]
      {
        if (this->IsDue)
        {
          this->Render();
        }
      });
  }
}

void Workbench::Render()
{
  this->IsDue = false;
  if (this->Window && !this->Builds)
  {
    this->Window->Render();
  }
}

void Workbench::OnFrameEnd()
{
  if (this->Builds || !this->Data.IsOpen())
  {
    return;
  }
  const double ms = 1000.0 * (vtkTimerLog::GetUniversalTime() - this->FrameBegan);
  this->Log.Frame(this->Data.View.Facts(), *this->Data.State().Isovalue, ms);
  if (this->Output.IsRecording())
  {
    try
    {
      this->Output.Add(this->Data.View.LastFrame());
    }
    catch (const UserError& mistake)
    {
      this->Output.Stop();
      this->Say(mistake.what(), true);
    }
  }
  emit this->FrameDrawn(ms);
}

void Workbench::Edit(const QString& name, const std::function<void(Look&)>& change)
{
  if (this->Data.IsOpen())
  {
    Look look = this->Data.Settings();
    change(look);
    this->Changes.push(new Change(*this, name, this->Gesture, look));
  }
}

void Workbench::SetDragging(bool isDragging)
{
  this->Window->SetDesiredUpdateRate(isDragging ? RateOfDrags : RateOfStills);
  if (!isDragging && this->Data.IsOpen() && !this->Data.DrawsSurfaces())
  {
    this->RenderSoon();
  }
}

void Workbench::Show(const Look& look)
{
  this->Data.SetSettings(look, !this->Builds);
  emit this->Changed();
  this->RenderSoon();
}

void Workbench::Turn(Choose what, int steps)
{
  const Choice& choice = ChoiceOf(what);
  this->BeginGesture();
  this->Edit(choice.Label,
    [&](Look& look)
    {
      const int count = static_cast<int>(choice.Values.size());
      look.Choices[what] = (look.Choices[what] + steps + count) % count;
    });
  this->Log.Event(choice.Name, this->Data.Settings().Choices.TextOf(what));
}

void Workbench::Start(const std::string& what, const Job& job, const std::function<void()>& done)
{
  this->IsStopped = false;
  this->Share = 0.0;
  this->What = what;
  this->Log.Event("began", what);
  const auto report = [this](double share)
  {
    if (share > this->Share + ProgressStep)
    {
      this->Share = share;
      QMetaObject::invokeMethod(this, [this, share] { emit this->Progressed(share); });
    }
    return !this->IsStopped;
  };
  this->Thread = std::thread(
    [this, job, report, done]
    {
      std::exception_ptr failure;
      try
      {
        job(report);
      }
      catch (...)
      {
        failure = std::current_exception();
      }
      QMetaObject::invokeMethod(this,
        [this, failure, done]
        {
          this->Thread.join();
          if (this->Builds)
          {
            this->Builds = false;
            this->Data.View.Renderer->DrawOn();
            this->Data.Apply();
          }
          if (this->Next)
          {
            this->Load(*std::exchange(this->Next, std::nullopt));
            return;
          }
          this->Try(
            [&]
            {
              if (failure)
              {
                std::rethrow_exception(failure);
              }
              done();
            });
          emit this->Changed();
        });
    });
  emit this->Changed();
}

void Workbench::Load(Request request)
{
  if (this->IsBusy()) // with what is not wanted any more
  {
    this->Cancel();
    this->Next = std::move(request);
    return;
  }
  const std::string& path = request.Wanted.Source.Path;
  const auto loaded = std::make_shared<Loaded>();
  this->Start(
    "Reading " + (path.empty() ? "four generated spheres" : path),
    [request, loaded](const Progress& progress) { *loaded = Model::Load(request, progress); },
    [this, loaded]
    {
      // Whoever stops does not want what was read in time, either.
      if (this->IsStopped)
      {
        throw UserError("Opening was stopped; what was shown stays.");
      }
      Request& request = loaded->For;
      const bool isSameFile = request.IsSameFile;
      if (isSameFile)
      {
        // Settings may have changed meanwhile.
        Look look = this->Data.Settings();
        look.Surfaces = request.KeepsSurfaces ? look.Surfaces : std::vector<Surface>();
        look.Nodes = request.KeepsSurfaces ? look.Nodes : std::vector<Node>();
        request.Wanted.Settings = look;
      }
      this->Refused = nullptr;
      this->Data.Adopt(std::move(*loaded));
      if (!isSameFile)
      {
        this->ListenToMapper();
      }
      this->SelectedSurface = 0;
      this->Changes.clear();
      this->Log.Event(isSameFile ? "shown" : "opened",
        isSameFile ? this->Data.Description() : this->Data.Data().Name);
      emit this->Opened();
      this->Say(this->Data.Data().Name + ": " + this->Data.Description());
      this->RenderSoon();
    });
}

void Workbench::Open(const Session& session)
{
  Request request;
  request.Wanted = session;
  this->Load(request);
}

void Workbench::OpenFirst(
  const Session& session, const std::function<void(const std::string&)>& refused)
{
  this->Refused = refused;
  this->Open(session);
}

void Workbench::OpenPath(const std::string& path)
{
  this->Try(
    [&]
    {
      if (IsSessionName(path))
      {
        this->SessionFile = path;
        this->Open(ReadSession(path));
        return;
      }
      Session session;
      session.Source.Path = path;
      session.Source.Spheres = this->Data.State().Source.Spheres;
      session.Settings.Choices = this->Data.Settings().Choices;
      session.Settings.Shading = this->Data.Settings().Shading;
      this->Open(session);
    });
}

void Workbench::Ask(const std::function<Request()>& request)
{
  if (!this->IsBusy())
  {
    this->Try([&] { this->Load(request()); });
  }
}

void Workbench::Build(const std::function<void(bool isBuilt)>& done)
{
  if (this->IsBusy() || !this->Data.IsOpen())
  {
    return;
  }
  this->Render(); // what is built is of the view that is seen
  this->Data.NoteIsomap();
  this->Builds = true;
  this->Data.View.Renderer->DrawOff();
  const auto isBuilt = std::make_shared<bool>(false);
  this->Start(
    "Building the isomap of this view",
    [this, isBuilt](const Progress& progress) { *isBuilt = this->Data.View.BuildIsomap(progress); },
    [this, isBuilt, done]
    {
      done(*isBuilt);
      this->Render();
    });
}

void Workbench::BuildIsomap()
{
  this->Build(
    [this](bool isBuilt)
    {
      this->Say(this->IsStopped
          ? "The isomap was stopped; the parts that are needed are built as you drag."
          : isBuilt ? "The isomap of this view is built: any isovalue is looked up."
                    : "There can be no isomap here; isovalues are found without it.",
        !isBuilt && !this->IsStopped);
    });
}

void Workbench::PrepareDrag()
{
  this->BeginGesture();
  if (this->Data.WantsIsomapAhead())
  {
    this->Build([this](bool) { this->Say(""); });
  }
}

void Workbench::Cancel()
{
  this->IsStopped = true;
}

std::size_t Workbench::Selected() const
{
  return std::min(this->SelectedSurface, this->Data.Settings().Surfaces.size() - 1);
}

void Workbench::Select(std::size_t surface)
{
  if (surface != this->SelectedSurface)
  {
    this->SelectedSurface = surface;
    emit this->Changed();
  }
}
