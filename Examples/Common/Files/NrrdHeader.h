// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef NrrdHeader_h
#define NrrdHeader_h

#include <vtkVector.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// What the header of an NRRD tells. VTK's own reader guesses which axis is one of colours, ignores
// directions, and reads the header of a text as samples.
struct NrrdHeader
{
  enum Encodings
  {
    Raw,
    Gzip,
    Text
  };
  Encodings Encoding = Raw;
  int Type = 0; // VTK_SHORT, ...
  bool IsBigEndian = false;
  std::array<int, 3> Dimensions = { 0, 0, 0 };
  int Components = 1;                   // of a sample
  int TimeSteps = 1;                    // volumes
  bool AreInterleaved = false;          // the time steps of a sample lie together
  std::vector<std::string> Files;       // of samples, in their order; none: they follow the header
  std::uintmax_t Size = 0;              // of the header
  std::intmax_t Skip = 0;               // bytes before the samples of a file; -1: they are its last
  std::array<vtkVector3d, 3> Axes = {}; // from a sample to its neighbour
  vtkVector3d Origin = { 0.0, 0.0, 0.0 };
  std::string From = "-y"; // where the viewer stands

  double Samples() const; // of the whole file
};

// Throws UserError for what is not read here.
NrrdHeader ReadNrrdHeader(const std::string& path);

#endif
