// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Actions_h
#define Actions_h

#include <string>
#include <vector>

// What a button or a key does once, beside turning a choice.
enum class Do
{
  Open,
  BuildIsomap,
  Picture,
  WindowPicture,
  Record,
  Save,
  Restore,
  ResetView,
  NextArray,
  EarlierStep,
  LaterStep,
  Help,
  Quit,
};

struct Action
{
  Do What;
  const char* Name;  // in logs
  const char* Label; // of its button; empty: it has none
  char Key;
  const char* Help;
};

const std::vector<Action>& AllActions();

// Lines of the help that are about the mouse and keys without a name.
struct Gesture
{
  const char* Keys;
  const char* Help;
};
const std::vector<Gesture>& AllGestures();

#endif
