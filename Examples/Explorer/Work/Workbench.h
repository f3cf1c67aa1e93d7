// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Workbench_h
#define Workbench_h

#include "Model/Film.h"
#include "Model/Recorder.h"
#include "Model/Sharing.h"

#include <vtkNew.h>
#include <vtkTemporalCoherenceRefiner.h>

#include <QObject>
#include <QPoint>
#include <QTimer>
#include <QUndoStack>

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <thread>

class vtkRenderWindow;

// What is done to the model: panels and menus ask for it here, and are told what came of it. What
// takes long is done in a thread of its own, one at a time. It knows no widget.
class Workbench : public QObject
{
  Q_OBJECT

public:
  // from, up: the viewer's place at first and the way up, as the model has them.
  Workbench(const std::string& output, const std::string& session = "explorer.session",
    const std::string& from = "", const std::string& up = "+z");
  ~Workbench() override;

  // Draws the view; with soon, once after all that waits to be done.
  void SetWindow(vtkRenderWindow* window);
  void RenderSoon();
  void Render();
  bool IsRenderDue() const { return this->Rendering.isActive(); }

  // All settings change here. Changes of a name that follow one another within a gesture, such as a
  // drag, are undone together.
  using Change = std::function<void(Look&)>;
  void Edit(const QString& name, const Change& change);
  void BeginGesture() { ++this->Gesture; }
  void EditOnce(const QString& name, const Change& change) // a gesture by itself
  {
    this->BeginGesture();
    this->Edit(name, change);
  }
  void Zoom(double steps);           // nearer, as a wheel is turned; drawn once for all steps
  void SetDragging(bool isDragging); // frames are to be made fast, or well
  void Show(const Look& look);       // as it is, for undo
  void Turn(std::size_t choice, int steps);
  // Of the range of a number, on the slider's scale.
  double ShareOf(const Setting& number);
  void SetShare(const Setting& number, double share);

  void Open(const Session& session);
  // A session, or a volume to be looked at likewise. Throws UserError.
  void OpenPath(const QString& path);
  void Ask(const std::function<Request()>& request); // for another array or time step
  void BuildIsomap(bool isAsked = true);             // else nothing is said of it
  void PrepareDrag();                                // of an isovalue
  void Cancel() { this->IsStopped = true; }
  bool IsBusy() const { return this->Thread.joinable(); }
  const std::string& Doing() const { return this->What; } // what takes long, for people
  bool IsBuilding() const { return this->Builds; } // or making pictures: the view stands still

  // These throw UserError. Pictures are final, which may take long.
  void SaveSession(const std::string& path);
  void SavePicture(const std::string& path = "", int width = 0, int height = 0);
  void ExportTriangles(const std::string& path);
  void Share(const SharedView& wanted);
  struct FilmOptions
  {
    FilmMotion Motion = FilmMotion::TurnAround; // a sweep is that of the selected marker
    int Frames = 120;
    int Rate = 25;              // frames a second
    std::string Format = "png"; // or "ogv"
    int Width = 0, Height = 0;
  };
  void MakeFilm(const FilmOptions& options);
  // From the first pixel of the view to the second; the third call ends it.
  void Measure(const QPoint& pixel);
  void ToggleRecording(); // of frames as they are seen
  void Say(const std::string& sentence, bool isWarning = false);
  void Try(const std::function<void()>& action); // tells of what is thrown

  // The marker that is worked on, of those that are drawn.
  const std::vector<Marker>& Markers() const { return this->Data.Markers(); }
  std::size_t Selected() const
  {
    return std::min(this->SelectedMarker, this->Markers().size() - 1);
  }
  void Select(std::size_t marker);
  void EditMarker(const QString& name, const std::function<void(Marker&)>& change);
  void AddMarker(const Marker& marker);
  void AddMarker(); // beside the selected one
  void RemoveMarker();
  bool CanRemove() const { return this->Markers().size() > (this->Data.DrawsSurfaces() ? 1 : 2); }

  Model Data;
  QUndoStack Changes;
  Recorder Output;
  vtkNew<vtkTemporalCoherenceRefiner> Refiner;              // of the window
  std::string SessionFile;                                  // to save to and to restore from
  std::function<void(const std::string&)> OnRefused;        // while set, it is told of what fails
  std::function<std::string(const std::string&)> OnMissing; // where the volume of a session is now
  std::function<std::optional<RawLayout>(const QString&)>
    OnRaw; // what lies in a file of samples alone

signals:
  void Leaving();                // the file that is open, for another one
  void Opened(bool isOtherFile); // or another array or step of the same one
  void Changed();                // settings, the selected marker, what is going on
  void Settled();                // the same, soon and less often: most panels need no more
  void FrameDrawn(double ms);    // of the window
  void Progressed(double share);
  void Refined(double share); // of the picture, as far as it will get; 1: it is final
  void Said(const QString& sentence, bool isWarning);

private:
  using Job = std::function<void(const Progress&)>;
  void Start(const std::string& what, const Job& job, const std::function<void()>& done);
  void StartOnView(const std::string& what, const Job& job, const std::function<void()>& done);
  void Finish(std::packaged_task<void()>& task, const std::function<void()>& done);
  void Load(Request request);
  void Take(Request& loaded);
  void SetRates(); // of frames, as something is dragged or not
  void ListenToMapper();
  void OnMessage(vtkObject*, unsigned long, void* text);
  void OnFrameBegin();
  void OnFrameEnd();
  void OnRefined();
  void OnAbortCheck();
  void RecordSeen();

  vtkRenderWindow* Window = nullptr;
  QTimer Settling, Rendering;
  std::thread Thread;
  std::string What;
  std::optional<Request> Next; // to be loaded after what is being stopped
  std::atomic<bool> IsStopped{ false };
  bool Builds = false;
  bool IsDragging = false;
  std::vector<Point> Measured; // places in the world
  int Gesture = 0;
  std::size_t SelectedMarker = 0;
  double FrameBegan = 0.0;
  QPoint Pointer;                     // where it was when the frame began
  vtkSmartPointer<vtkImageData> Seen; // and is to be recorded, unless it gets better
};

#endif
