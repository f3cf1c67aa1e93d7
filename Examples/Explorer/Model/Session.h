// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Session_h
#define Session_h

#include "Model/Choices.h"
#include "Program/VolumeSource.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

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

using Rgb = std::array<double, 3>; // 0 to 1

struct Surface
{
  double Isovalue = 0.0;
  double Opacity = 1.0;
  bool IsVisible = true;
  std::optional<Rgb> Color = {}; // none: the palette's
};

// A node of the functions that blended volumes are drawn with.
struct Node
{
  double Value = 0.0;
  double Opacity = 0.0;
  std::optional<Rgb> Color = {}; // none: the palette's
};

struct Plane // in the world; what the normal points to is seen
{
  std::array<double, 3> Origin = {};
  std::array<double, 3> Normal = {};
};

// All settings that can be undone.
struct Look
{
  Chosen Choices;
  std::vector<Surface> Surfaces; // one at least, once a volume is open
  std::vector<Node> Nodes;       // in ascending order of values; two at least
  double Density = 1.0;          // of blended volumes: a hundredth of the volume is so opaque
  std::optional<Plane> Clip;
  std::optional<std::array<double, 6>> Crop;    // a box along the data's own axes
  std::optional<std::array<double, 4>> Shading; // ambient to power; none: the material's
};

// All that a picture depends on: what a session file holds.
struct Session
{
  VolumeSource Source;
  int Component = 0;              // of the array; -1: the length of its vectors
  std::optional<double> Isovalue; // of the first surface; none: chosen from the histogram
  std::optional<CameraState> Camera;
  Look Settings;
};

// Text, one "key = value" a line. Both throw UserError.
void WriteSession(const Session& session, const std::string& path);
Session ReadSession(const std::string& path);

bool IsSessionName(const std::string& path); // ends with .session

#endif
