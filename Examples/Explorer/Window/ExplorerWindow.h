// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExplorerWindow_h
#define ExplorerWindow_h

#include "Model/FrameLog.h"
#include "Model/Model.h"
#include "Panels/Desk.h"
#include "Window/Options.h"
#include "Window/Recorder.h"
#include "Window/Style.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <functional>
#include <string>
#include <vector>

// The window: passes on to the model what is done by hand, and shows what comes of it.
class ExplorerWindow : private Hands
{
public:
  // Throws UserError if the log cannot be written.
  explicit ExplorerWindow(const Options& options);
  ~ExplorerWindow() override;

  // Throws UserError.
  void Open(const Session& session);

  // Until it is closed.
  void Run();

  void Render();

  // As it was drawn last.
  vtkSmartPointer<vtkImageData> PictureOfWindow();

  vtkRenderWindow* Window() { return this->Shown; }
  vtkRenderWindowInteractor* Interactor() { return this->Events; }
  Model& Opened() { return this->Data; }
  Desk& Panels() { return this->Parts; }

private:
  bool IsBusy() const override { return this->Busy; }
  Grip Press(int x, int y, bool isRight) override;
  void Drag(int x, int y) override;
  bool Wheel(int x, int y, int turns) override;
  void Key(const std::string& name, char character, bool hasShift) override;
  void Drop(const std::vector<std::string>& paths) override;

  void KeyInList(const std::string& name);
  void Perform(Do action);
  void Turn(Choose what, int steps);
  void SetIsovalueAt(int x);
  void OpenPath(const std::string& path);
  void ShowOther(const std::function<void()>& turn);
  void BuildIsomap();
  void PrepareDrag();
  void SavePicture();
  void ToggleRecording();
  void ToggleHelp();
  void ToggleFiles();

  // Tells of a mistake in the window and on the error stream; the program goes on.
  void Try(const std::function<void()>& action);
  void Say(const std::string& sentence, bool isWarning = false);

  void ObserveFrames();
  void OnFrameBegin();
  void OnFrameEnd();
  void Record();
  bool OnProgress(const std::string& what, double share);
  void LogPlaces();

  struct Work; // while it lives, something takes long

  const std::string SessionFile;
  Model Data;
  vtkNew<vtkRenderWindow> Shown;
  vtkNew<vtkRenderWindowInteractor> Events;
  vtkNew<Style> Mouse;
  Desk Parts;
  Recorder Output;
  FrameLog Log;

  bool Busy = false;
  bool ArePlacesKnown = false;
  bool IsStopped = false;
  double WorkBegan = 0.0;
  double ProgressShown = 0.0;
  double FrameBegan = 0.0;
};

#endif
