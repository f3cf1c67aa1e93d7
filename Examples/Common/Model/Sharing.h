// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Sharing_h
#define Sharing_h

#include "Model/VolumeView.h"

#include <array>
#include <optional>
#include <string>

// A picture of a view for every isovalue, to be written for others.
struct SharedView
{
  std::string Path; // ends in .html, .tcview or .cdb
  std::string Title, Caption, Citation, Units;
  std::optional<std::array<double, 2>> Range; // of isovalues; none: those of most surfaces
  double Tolerance = 0.1;                     // in voxels
  int Width = 1024, Height = 1024;
  int Views = 1; // around the volume
};

// Writes it, in any thread. Returns what is where, for people. Throws UserError.
std::string ShareView(VolumeView& view, const SharedView& wanted, const Progress& progress);

#endif
