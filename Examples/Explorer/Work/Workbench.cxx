// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Work/Workbench.h"

#include "Model/Triangles.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Picture.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkMath.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTimerLog.h>

#include <QCursor>
#include <QFile>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>

namespace
{

constexpr double ProgressStep = 0.01; // of the whole
constexpr int SettleAfter = 100;      // ms: what is drawn in each frame delays it

// Frames a second. Those of blended volumes take long, so that the still ones, too, are made in
// parts: events do not wait longer than for one part.
constexpr double RateOfDrags = 20.0;
constexpr double RateOfStills = 1e-4;
constexpr double RateOfParts = 19.0;

constexpr double ZoomOfStep = 1.21; // as VTK's styles have it

class LookChange : public QUndoCommand
{
public:
  LookChange(Workbench& bench, const QString& name, int gesture, const Look& after)
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
    this->After = isSame ? static_cast<const LookChange*>(other)->After : this->After;
    return isSame;
  }

private:
  Workbench& Bench;
  int Gesture;
  Look Before, After;
};

}

Workbench::Workbench(const std::string& output, const std::string& session, const std::string& from,
  const std::string& up)
  : Data(from, up)
  , Output(output)
  , SessionFile(session)
{
  this->ListenToMapper();
  for (QTimer* timer : { &this->Settling, &this->Rendering })
  {
    timer->setSingleShot(true);
  }
  this->Settling.setInterval(SettleAfter);
  QObject::connect(&this->Settling, &QTimer::timeout, this, &Workbench::Settled);
  QObject::connect(&this->Rendering, &QTimer::timeout, this, &Workbench::Render);
  QObject::connect(this, &Workbench::Changed, this,
    [this]
    {
      if (!this->Settling.isActive())
      {
        this->Settling.start();
      }
    });
}

Workbench::~Workbench()
{
  this->Cancel();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void Workbench::SetWindow(vtkRenderWindow* window)
{
  this->Window = window;
  window->AddRenderer(this->Data.View.Renderer);
  window->AddObserver(vtkCommand::StartEvent, this, &Workbench::OnFrameBegin);
  window->AddObserver(vtkCommand::EndEvent, this, &Workbench::OnFrameEnd);
  this->Refiner->SetInteractor(window->GetInteractor());
  this->Refiner->AddObserver(vtkCommand::ProgressEvent, this, &Workbench::OnRefined);
  this->Refiner->AddObserver(vtkCommand::AbortCheckEvent, this, &Workbench::OnAbortCheck);
}

// With an observer, VTK writes nothing on the terminal itself.
void Workbench::ListenToMapper()
{
  for (const auto event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
  {
    this->Data.View.Mapper->AddObserver(event, this, &Workbench::OnMessage);
  }
}

// In any thread. The last line of what VTK says is the sentence itself.
void Workbench::OnMessage(vtkObject*, unsigned long, void* text)
{
  const std::string all = static_cast<const char*>(text);
  const std::size_t begin = all.find("): ");
  const std::string sentence = begin == std::string::npos ? all : all.substr(begin + 3);
  QMetaObject::invokeMethod(
    this, [=] { this->Say(sentence.substr(0, sentence.find_last_not_of("\n ") + 1), true); });
}

void Workbench::Render()
{
  if (this->Window && !this->Builds)
  {
    this->Window->Render();
  }
}

// What has changed is not shown by a frame that only makes the last picture better: mouse moves
// stop that one, and films leave it out.
void Workbench::RenderSoon()
{
  this->Refiner->EnabledOff();
  this->Rendering.start(0);
}

void Workbench::OnFrameBegin()
{
  this->FrameBegan = vtkTimerLog::GetUniversalTime();
  this->Rendering.stop();
  if (this->Refiner->GetRendering())
  {
    this->Pointer = QCursor::pos();
  }
}

void Workbench::OnRefined()
{
  emit this->Refined(this->Builds ? 1.0 : this->Refiner->GetProgress());
}

// A picture that gets better waits for whoever moves the mouse.
void Workbench::OnAbortCheck()
{
  if (QCursor::pos() != this->Pointer)
  {
    this->Window->SetAbortRender(1);
  }
}

void Workbench::OnFrameEnd()
{
  if (this->Builds || !this->Data.IsOpen())
  {
    return;
  }
  this->Refiner->SetEnabled(!this->IsRenderDue());
  const double ms = 1000.0 * (vtkTimerLog::GetUniversalTime() - this->FrameBegan);
  if (this->Output.IsRecording() && !this->Window->GetAbortRender())
  {
    this->Try(
      [this]
      {
        if (!this->Refiner->GetRendering())
        {
          this->RecordSeen();
        }
        this->Seen = this->Data.View.LastFrame();
      });
  }
  emit this->FrameDrawn(ms);
}

// What was seen before the next frame, as good as it got.
void Workbench::RecordSeen()
{
  if (const auto picture = std::exchange(this->Seen, nullptr))
  {
    this->Output.Add(picture);
  }
}

void Workbench::Edit(const QString& name, const Change& change)
{
  if (this->Data.IsOpen())
  {
    Look look = this->Data.Settings();
    change(look);
    this->Data.ForgetPreset(look);
    this->Changes.push(new LookChange(*this, name, this->Gesture, look));
  }
}

void Workbench::Zoom(double steps)
{
  vtkRenderer* const renderer = this->Data.View.Renderer;
  const double factor = std::pow(ZoomOfStep, steps);
  vtkCamera* const camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  }
  else
  {
    camera->Dolly(factor);
    renderer->ResetCameraClippingRange();
  }
  this->RenderSoon();
}

void Workbench::SetDragging(bool isDragging)
{
  this->IsDragging = isDragging;
  this->SetRates();
  if (!isDragging && this->Data.IsOpen())
  {
    this->RenderSoon(); // which refines it
  }
}

void Workbench::SetRates()
{
  const double still = this->Data.IsOpen() && this->Data.Blends() ? RateOfParts : RateOfStills;
  this->Window->GetInteractor()->SetDesiredUpdateRate(RateOfDrags);
  this->Window->GetInteractor()->SetStillUpdateRate(still);
  this->Window->SetDesiredUpdateRate(this->IsDragging ? RateOfDrags : still);
}

void Workbench::Show(const Look& look)
{
  this->Data.SetSettings(look, !this->Builds);
  this->SetRates();
  this->RenderSoon();
  emit this->Changed();
}

void Workbench::Turn(std::size_t choice, int steps)
{
  this->EditOnce(AllSettings()[choice].Label,
    [&](Look& look)
    {
      const auto count = static_cast<int>(AllSettings()[choice].Words.size());
      this->Data.SetChoice(
        look, choice, (static_cast<int>(look.Values[choice]) + steps + count) % count);
    });
}

double Workbench::ShareOf(const Setting& number)
{
  const double value = this->Data.NumberOf(number, this->Data.Settings(), this->Selected());
  const auto [least, most] = this->Data.RangeOf(number);
  const double share = number.IsLogarithmic ? std::log(value / least) / std::log(most / least)
                                            : (value - least) / (most - least);
  return std::isfinite(share) ? share : 0.0; // a range may be empty
}

void Workbench::SetShare(const Setting& number, double share)
{
  this->Edit(number.Label,
    [&](Look& look)
    {
      const auto [least, most] = this->Data.RangeOf(number);
      this->Data.SetNumber(number, look, this->Selected(),
        number.IsLogarithmic ? least * std::pow(most / least, share)
                             : least + share * (most - least));
    });
}

// Does the job in a thread, and in this one what is done with its result.
void Workbench::Start(const std::string& what, const Job& job, const std::function<void()>& done)
{
  this->IsStopped = false;
  this->What = what;
  const Progress tell = [this, told = 0.0](double share) mutable
  {
    if (share > told + ProgressStep)
    {
      told = share;
      QMetaObject::invokeMethod(this, [this, share] { emit this->Progressed(share); });
    }
    return !this->IsStopped;
  };
  const auto task = std::make_shared<std::packaged_task<void()>>([=] { job(tell); });
  this->Thread = std::thread(
    [=]
    {
      (*task)();
      QMetaObject::invokeMethod(this, [=] { this->Finish(*task, done); });
    });
  emit this->Changed();
}

// A job of which nothing is to be seen: the view stands still.
void Workbench::StartOnView(
  const std::string& what, const Job& job, const std::function<void()>& done)
{
  this->Builds = true;
  this->Refiner->EnabledOff();
  this->Data.View.Renderer->DrawOff();
  emit this->Refined(1.0);
  this->Start(what, job, done);
}

void Workbench::Finish(std::packaged_task<void()>& task, const std::function<void()>& done)
{
  this->Thread.join();
  if (std::exchange(this->Builds, false))
  {
    this->Data.View.Renderer->DrawOn();
    this->Data.Apply();
    this->Refiner->EnabledOn();
    this->RenderSoon();
  }
  if (this->Next)
  {
    this->Load(*std::exchange(this->Next, std::nullopt));
    return;
  }
  this->Try(
    [&]
    {
      task.get_future().get(); // throws what the job has thrown
      done();
    });
  emit this->Changed();
  emit this->Settled(); // at once: the next key may need what was off meanwhile
}

void Workbench::Open(const Session& session)
{
  Request request;
  request.Wanted = session;
  this->Load(request);
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
  const std::string what = "Reading " + (path.empty() ? "four generated spheres" : path);
  const auto shared = std::make_shared<Request>(std::move(request));
  this->Start(
    what, [shared](const Progress& progress) { Model::Load(*shared, progress); },
    [this, shared] { this->Take(*shared); });
}

void Workbench::Take(Request& loaded)
{
  // Whoever stops does not want what was read in time, either.
  if (this->IsStopped)
  {
    throw UserError("Opening was stopped; what was shown stays.");
  }
  if (!loaded.IsSameFile && this->Data.IsOpen())
  {
    emit this->Leaving();
  }
  this->Data.Adopt(loaded);
  if (!loaded.IsSameFile)
  {
    this->ListenToMapper();
  }
  this->SelectedMarker = 0;
  this->Measured.clear();
  this->Changes.clear();
  this->SetRates();
  emit this->Opened(!loaded.IsSameFile);
  emit this->Settled();
  const std::string& remark = this->Data.Data().Remark;
  this->Say(this->Data.Data().Name + ": " + this->Data.Description() +
    (remark.empty() ? "" : ".  " + remark));
  this->RenderSoon();
}

void Workbench::OpenPath(const QString& name)
{
  if (name.isEmpty())
  {
    return; // the dialog was left
  }
  const std::string path = QFile::encodeName(name).toStdString();
  Session session;
  session.Source.Path = path;
  const auto& now = this->Data.Settings().Values;
  std::copy(now.begin(), now.begin() + Row::Density, session.Settings.Values.begin());
  if (session.Settings.Choice(Row::Drawing) == Drawing::Labels)
  {
    session.Settings.Values[Row::Drawing] = Drawing::Surfaces; // the next file may be a scan
  }
  session.MaySuitFile = session.Settings.Choice(Row::Drawing) == Drawing::Surfaces;
  if (this->OnRaw && name.endsWith(".raw", Qt::CaseInsensitive))
  {
    session.Source.Raw = this->OnRaw(name);
    if (!session.Source.Raw)
    {
      return; // the dialog was left
    }
  }
  if (IsSessionName(path))
  {
    this->SessionFile = path;
    session = ReadSession(path);
    std::string& volume = session.Source.Path;
    if (!volume.empty() && !QFile::exists(QFile::decodeName(volume.c_str())) && this->OnMissing)
    {
      volume = this->OnMissing(volume);
    }
  }
  this->Open(session);
}

void Workbench::Ask(const std::function<Request()>& request)
{
  if (!this->IsBusy())
  {
    this->Try([&] { this->Load(request()); });
  }
}

void Workbench::BuildIsomap(bool isAsked)
{
  if (this->IsBusy() || !this->Data.IsOpen())
  {
    return;
  }
  this->Render(); // what is built is of the view that is seen
  this->Data.NoteIsomap();
  const auto isBuilt = std::make_shared<bool>(false);
  this->StartOnView(
    "Building the isomap of this view",
    [this, isBuilt](const Progress& progress) { *isBuilt = this->Data.View.BuildIsomap(progress); },
    [this, isBuilt, isAsked]
    {
      this->Say(!isAsked ? ""
          : this->IsStopped
          ? "The isomap was stopped; the parts that are needed are built as you drag."
          : *isBuilt ? "The isomap of this view is built: any isovalue is looked up."
                     : "There can be no isomap here; isovalues are found without it.",
        isAsked && !*isBuilt && !this->IsStopped);
      this->Render();
    });
}

void Workbench::PrepareDrag()
{
  this->BeginGesture();
  if (this->Data.WantsIsomapAhead())
  {
    this->BuildIsomap(false);
  }
}

void Workbench::SaveSession(const std::string& path)
{
  this->Data.Save(path);
  this->SessionFile = path;
  this->RenderSoon();
  this->Say("Saved " + path);
}

// Without a path it is counted up, without a size it is that of the view, as often as chosen.
void Workbench::SavePicture(const std::string& path, int width, int height)
{
  if (this->IsBusy())
  {
    throw UserError(this->What + ": wait for it, or stop it with Escape.");
  }
  const int scale = std::stoi(this->Data.Settings().TextOf(Row::Scale));
  const int* size = this->Data.View.Renderer->GetSize();
  width = width > 0 ? width : scale * size[0];
  height = height > 0 ? height : scale * size[1];
  const auto picture = std::make_shared<vtkSmartPointer<vtkImageData>>();
  this->StartOnView(
    "Making the picture",
    [=, hasBackground = this->Data.Settings().Values[Row::Transparency] == 0.0](
      const Progress& progress)
    { *picture = this->Data.View.Picture(width, height, progress, hasBackground); },
    [=]
    {
      if (!path.empty())
      {
        WritePng(*picture, path, "name another file");
      }
      this->Say("Saved " + (path.empty() ? this->Output.Save(*picture) : path));
    });
}

void Workbench::Share(const SharedView& wanted)
{
  if (this->IsBusy())
  {
    throw UserError(this->What + ": wait for it, or stop it with Escape.");
  }
  const auto written = std::make_shared<std::string>();
  this->StartOnView(
    "Finding the surfaces of all isovalues",
    [=](const Progress& progress) { *written = ShareView(this->Data.View, wanted, progress); },
    [=] { this->Say(*written); });
}

void Workbench::ExportTriangles(const std::string& path)
{
  if (this->IsBusy())
  {
    throw UserError(this->What + ": wait for it, or stop it with Escape.");
  }
  const auto count = std::make_shared<vtkIdType>(0);
  this->Start(
    "Exporting triangles",
    [=, volume = this->Data.Data(), component = this->Data.State().Component,
      look = this->Data.Settings()](const Progress&)
    {
      const auto triangles = TrianglesOf(volume, component, look);
      WriteTriangles(triangles, path);
      *count = triangles->GetNumberOfCells();
    },
    [=] { this->Say("Saved " + path + ": " + std::to_string(*count) + " triangles"); });
}

void Workbench::Measure(const QPoint& pixel)
{
  VolumeView& view = this->Data.View;
  if (this->Measured.size() == 2)
  {
    this->Measured.clear();
    view.HideRuler();
    this->Say("");
  }
  else
  {
    const auto seen = view.SeenAt(pixel.x(), view.Renderer->GetSize()[1] - 1 - pixel.y());
    if (!seen)
    {
      throw UserError("There is nothing under the pointer; point at a surface.");
    }
    this->Measured.push_back(seen->Place);
    this->Say("Point at the other end, and measure once more.");
  }
  if (this->Measured.size() == 2)
  {
    const double distance = std::sqrt(
      vtkMath::Distance2BetweenPoints(this->Measured[0].data(), this->Measured[1].data()));
    view.ShowRuler(this->Measured[0], this->Measured[1]);
    this->Say("Distance: " + QString::number(distance, 'g', 5).toStdString());
  }
  this->RenderSoon();
}

void Workbench::MakeFilm(const FilmOptions& options)
{
  if (this->IsBusy())
  {
    throw UserError(this->What + ": wait for it, or stop it with Escape.");
  }
  const auto film = std::make_shared<Recorder>(this->Output.Directory);
  film->Start(options.Format, "", options.Rate);
  const CameraState camera = this->Data.View.Camera();
  // Of what the thread changes, nothing else is seen: Finish() applies the settings again.
  const auto job = [=, look = this->Data.Settings(), marker = this->Selected()](
                     const Progress& progress)
  {
    VolumeView& view = this->Data.View;
    try
    {
      ForEachFrame(this->Data, look, marker, options.Motion, options.Frames,
        [&](int frame)
        {
          film->Add(view.Picture(options.Width, options.Height,
            [&](double share) { return progress((frame + share) / options.Frames); }));
          return !this->IsStopped;
        });
    }
    catch (const UserError&)
    {
      view.SetCamera(camera);
      if (!this->IsStopped) // else the pictures before are the film
      {
        throw;
      }
    }
    view.SetCamera(camera);
  };
  this->StartOnView("Making a film", job, [=] { this->Say(film->Stop()); });
}

void Workbench::ToggleRecording()
{
  if (this->Output.IsRecording())
  {
    this->RecordSeen();
    this->Say(this->Output.Stop());
  }
  else
  {
    this->Output.Start(this->Data.Settings().TextOf(Row::Film));
    this->Say("Recording every frame");
  }
  emit this->Changed();
}

void Workbench::Say(const std::string& said, bool isWarning)
{
  const std::string sentence = Printable(said);
  if (!sentence.empty())
  {
    std::fprintf(
      isWarning ? stderr : stdout, "%s%s\n", isWarning ? "Explorer: " : "", sentence.c_str());
    std::fflush(stdout);
  }
  emit this->Said(QString::fromStdString(sentence), isWarning);
}

void Workbench::Try(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const std::exception& failure)
  {
    const std::string sentence = SentenceOf(failure);
    this->OnRefused && !this->IsStopped ? this->OnRefused(sentence) : this->Say(sentence, true);
  }
}

void Workbench::Select(std::size_t marker)
{
  if (std::exchange(this->SelectedMarker, marker) != marker)
  {
    emit this->Changed();
  }
}

void Workbench::EditMarker(const QString& name, const std::function<void(Marker&)>& change)
{
  const std::size_t marker = this->Selected();
  this->Edit(name, [&](Look& look) { change(this->Data.MarkersOf(look)[marker]); });
}

void Workbench::AddMarker(const Marker& marker)
{
  if (this->Data.Projects()) // from black to white: two ends
  {
    return;
  }
  std::size_t place = this->Markers().size();
  this->EditOnce(tr("marker"),
    [&](Look& look)
    {
      std::vector<Marker>& markers = this->Data.MarkersOf(look);
      const auto after = std::find_if(markers.begin(), markers.end(),
        [&](const Marker& other) { return other.Value > marker.Value; });
      const auto at = this->Data.DrawsSurfaces() ? markers.end() : after;
      place = static_cast<std::size_t>(at - markers.begin());
      markers.insert(at, marker);
    });
  this->Select(place);
}

void Workbench::AddMarker()
{
  Marker marker = this->Markers()[this->Selected()];
  const double share = this->Data.ShareOf(marker.Value);
  marker.Value = this->Data.ValueAt(share + (share < 0.5 ? 0.2 : -0.2));
  if (this->Data.DrawsSurfaces())
  {
    marker.Color = ContrastOf(this->Markers().size());
    marker.Opacity = 1.0;
  }
  const bool hidesOther = this->Data.DrawsSurfaces() && this->Markers().size() == 1;
  this->AddMarker(marker);
  if (hidesOther)
  {
    // The outer one, as a rule that of less value, lets the other one be seen.
    this->Edit(tr("marker"),
      [](Look& look)
      {
        std::vector<Marker>& both = look.Surfaces;
        Marker& outer = both[0].Value < both[1].Value ? both[0] : both[1];
        outer.Opacity = std::min(outer.Opacity, SeeThrough);
      });
  }
}

void Workbench::RemoveMarker()
{
  const auto selected = static_cast<std::ptrdiff_t>(this->Selected());
  this->EditOnce(tr("marker"),
    [&](Look& look)
    {
      std::vector<Marker>& markers = this->Data.MarkersOf(look);
      markers.erase(
        markers.begin() + selected, markers.begin() + selected + (this->CanRemove() ? 1 : 0));
    });
}
