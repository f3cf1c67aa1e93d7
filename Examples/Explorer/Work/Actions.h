// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Actions_h
#define Actions_h

#include <vector>

// What a menu or a key does once, beside turning a choice.
enum class Do
{
  Open,
  OpenFolder,
  SaveSession,
  SaveSessionAs,
  Restore,
  Picture,
  PictureAs,
  WindowPicture,
  Record,
  Film,
  Quit,
  Undo,
  Redo,
  AddSurface,
  RemoveSurface,
  Clip,
  Crop,
  ResetView,
  UpsideDown,
  FullScreen,
  BuildIsomap,
  NextArray,
  EarlierStep,
  LaterStep,
  Play,
  Stop,
  Keys,
};

struct Action
{
  Do What;
  const char* Menu;
  const char* Name;
  const char* Keys; // the first is shown
  const char* Help;
};

const std::vector<Action>& AllActions();

// Lines of the help that are about the mouse and keys of parts of the window.
struct Gesture
{
  const char* Keys;
  const char* Help;
};
const std::vector<Gesture>& AllGestures();

#endif
