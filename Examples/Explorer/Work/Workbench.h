// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Workbench_h
#define Workbench_h

#include "Model/Model.h"
#include "Work/FrameLog.h"
#include "Work/Options.h"
#include "Work/Recorder.h"

#include <QObject>
#include <QTimer>
#include <QUndoStack>

#include <atomic>
#include <functional>
#include <thread>

class vtkRenderWindow;

// What is done to the model: panels and menus ask for it here, and are told what came of it. What
// takes long is done in a thread of its own, one at a time. It knows no widget.
class Workbench : public QObject
{
  Q_OBJECT

public:
  // Throws UserError if the log cannot be written.
  explicit Workbench(const Options& options);
  ~Workbench() override;

  // Draws the view; with soon, once after all that waits to be done.
  void SetWindow(vtkRenderWindow* window);
  void RenderSoon();
  void Render();
  bool IsRenderDue() const { return this->IsDue; }

  // All settings change here. Changes of a name that follow one another within a gesture, such as a
  // drag, are undone together.
  void Edit(const QString& name, const std::function<void(Look&)>& change);
  void BeginGesture() { ++this->Gesture; }
  void SetDragging(bool isDragging); // frames are to be made fast, or well
  void Show(const Look& look);       // as it is, for undo
  void Turn(Choose what, int steps);

  void Open(const Session& session);
  void OpenFirst(const Session& session, const std::function<void(const std::string&)>& refused);
  void OpenPath(const std::string& path); // a session, or a volume to be looked at likewise
  void Ask(const std::function<Request()>& request); // for another array or time step
  void BuildIsomap();
  void PrepareDrag(); // of an isovalue
  void Cancel();
  bool IsBusy() const { return this->Thread.joinable(); }
  const std::string& Doing() const { return this->What; } // what takes long, for people
  bool IsBuilding() const { return this->Builds; }        // an isomap: the view stands still

  void SaveSession(const std::string& path);
  void SavePicture(const std::string& path = "", int width = 0, int height = 0);
  void ToggleRecording();
  void Say(const std::string& sentence, bool isWarning = false);
  void Try(const std::function<void()>& action); // tells of what is thrown

  std::size_t Selected() const; // surface
  void Select(std::size_t surface);

  const Options Chosen;
  Model Data;
  QUndoStack Changes;
  Recorder Output;
  FrameLog Log;
  std::string SessionFile;

signals:
  void Opened();              // other data
  void Changed();             // settings, the selected surface, what is going on
  void Settled();             // the same, soon and less often: most panels need no more
  void FrameDrawn(double ms); // of the window
  void Progressed(double share);
  void Said(const QString& sentence, bool isWarning);

private:
  using Job = std::function<void(const Progress&)>;
  void Start(const std::string& what, const Job& job, const std::function<void()>& done);
  void Load(Request request);
  void Build(const std::function<void(bool isBuilt)>& done);
  void ListenToMapper();
  void OnFrameEnd();

  vtkRenderWindow* Window = nullptr;
  QTimer Settling;
  std::thread Thread;
  std::string What;
  std::function<void(const std::string&)> Refused; // until something is open
  std::optional<Request> Next;                     // to be loaded after what is being stopped
  std::atomic<bool> IsStopped{ false };
  std::atomic<double> Share{ 0.0 };
  bool Builds = false;
  bool IsDue = false;
  int Gesture = 0;
  std::size_t SelectedSurface = 0;
  double FrameBegan = 0.0;
};

#endif
