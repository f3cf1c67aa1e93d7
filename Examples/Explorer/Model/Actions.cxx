// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Actions.h"

const std::vector<Action>& AllActions()
{
  static const std::vector<Action> actions = {
    { Do::Open, "open", "Open", 'o', "open a volume or a session" },
    { Do::BuildIsomap, "build", "Build map", 'b',
      "build the isomap of this view, for all isovalues" },
    { Do::Picture, "picture", "Picture", 's', "save a picture (PNG)" },
    { Do::WindowPicture, "window-picture", "", 'S',
      "save a picture of the window, panels and all" },
    { Do::Record, "record", "Record", 'r', "begin and end a recording" },
    { Do::Save, "save", "Save", 'w', "save the session" },
    { Do::Restore, "restore", "Restore", 'z', "restore the saved session" },
    { Do::ResetView, "reset", "Reset view", 'h', "see all of the volume" },
    { Do::NextArray, "next-array", "", 'n', "the next array of the file" },
    { Do::EarlierStep, "earlier", "", ',', "the time step before" },
    { Do::LaterStep, "later", "", '.', "the next time step" },
    { Do::Help, "help", "Keys", '?', "show or hide these lines; also F1" },
    { Do::Quit, "quit", "", 'q', "end" },
  };
  return actions;
}

const std::vector<Gesture>& AllGestures()
{
  static const std::vector<Gesture> gestures = {
    { "left drag", "turn; with Shift: move" },
    { "wheel, right drag", "nearer and farther" },
    { "drag in histogram", "isovalue" },
    { "Left, Right", "isovalue by 1/256 of the range; Shift: by 10/256" },
    { "drop a file", "open it" },
    { "Escape", "close a list, stop what takes long" },
  };
  return gestures;
}
