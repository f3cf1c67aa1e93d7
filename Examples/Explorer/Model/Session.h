// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Session_h
#define Session_h

#include "Model/Choices.h"
#include "Program/VolumeSource.h"

#include <array>
#include <optional>
#include <string>

struct CameraState
{
  std::array<double, 3> Position = {};
  std::array<double, 3> FocalPoint = {};
  std::array<double, 3> ViewUp = {};
  double ViewAngle = 30.0; // degrees

  bool operator==(const CameraState& other) const
  {
    return this->Position == other.Position && this->FocalPoint == other.FocalPoint &&
      this->ViewUp == other.ViewUp && this->ViewAngle == other.ViewAngle;
  }
};

// All that a picture depends on: what a session file holds.
struct Session
{
  VolumeSource Source;
  std::optional<double> Isovalue; // none: chosen from the histogram
  std::optional<CameraState> Camera;
  Chosen Choices;
};

// Text, one "key = value" a line. Both throw UserError.
void WriteSession(const Session& session, const std::string& path);
Session ReadSession(const std::string& path);

bool IsSessionName(const std::string& path); // ends with .session

#endif
