// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Session_h
#define Session_h

#include "Model/Settings.h"
#include "Program/VolumeSource.h"

#include <string>

struct CameraState
{
  Point Position = {};
  Point FocalPoint = {};
  Point ViewUp = {};
  double ViewAngle = 30.0;    // degrees
  double ParallelScale = 1.0; // half of the view's height in the world, without perspective
};

// All that a picture depends on: what a session file holds.
struct Session
{
  VolumeSource Source;
  int Component = 0;              // of the array; -1: the length of its vectors
  std::optional<double> Isovalue; // of the first surface; none: chosen from the histogram
  bool HasCamera = false;         // else all of the volume is seen
  bool MaySuitFile = false; // nobody has chosen how to draw: labels, if a file tells their names
  CameraState Camera;
  Look Settings;
};

// A view without a direction would draw nothing, nor would one from where numbers end.
bool IsUsable(const CameraState& camera);

// Text, one "key = value" a line. Both throw UserError.
void WriteSession(Session session, const std::string& path);
Session ReadSession(const std::string& path);

bool IsSessionName(const std::string& path); // ends with .session

#endif
