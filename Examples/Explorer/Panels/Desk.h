// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Desk_h
#define Desk_h

#include "Panels/FileListPanel.h"
#include "Panels/HelpPanel.h"
#include "Panels/IsovaluePanel.h"
#include "Panels/MessagePanel.h"
#include "Panels/ProgressPanel.h"
#include "Panels/StatisticsPanel.h"
#include "Panels/SwitchBar.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <array>

class Model;
class vtkRenderWindow;

// All panels, where they belong in the window.
class Desk
{
public:
  Desk(vtkRenderWindow* window, Model& model);

  // Puts everything in its place if the window's size changed; true if it did.
  bool Arrange();

  // Draws what is not as it should be any more. Called when the view is drawn and the panels are
  // not.
  void Refresh();

  // After a change of the model.
  void Invalidate();

  void Say(const std::string& sentence, bool isWarning);
  void ClearMessage();

private:
  // On a layer above the view's. First, so that it outlives the panels.
  vtkNew<vtkRenderer> Layer;

public:
  IsovaluePanel Isovalue;
  StatisticsPanel Statistics;
  SwitchBar Switches;
  MessagePanel Message;
  HelpPanel Help;
  FileListPanel Files;
  ProgressPanel Progress;

private:
  std::array<Panel*, 7> All();

  vtkRenderWindow* Window;
  Model& Shown;
  std::array<int, 2> Size = { 0, 0 };
};

#endif
