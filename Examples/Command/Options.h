// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include "Model/Film.h"
#include "Model/Sharing.h"
#include "Program/CommandLine.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

// What the command line says.
struct Options : CommonOptions
{
  std::vector<double> Isovalues; // none: one is chosen
  std::vector<double> Opacities; // of the isovalues, in their order; the last one goes on
  std::vector<Rgb> Colors;       // of the isovalues, too
  std::vector<std::pair<Row::Which, int>> Choices; // words that were named, for the look
  std::string ColorBy;                             // name of an array, and a component; empty: none
  std::optional<int> Preset;                       // place of its word
  double Shift = 0.0;
  std::optional<double> Window, Level;
  double Azimuth = 0.0, Elevation = 0.0; // degrees
  double Zoom = 1.0;
  std::optional<std::size_t> ClipAxis;
  std::optional<double> ClipAt;     // along the axis; none: in the middle
  bool IsClipFlipped = false;       // what lies below is seen
  int Samples = 1;                  // rays a pixel, beside those at edges: a square number
  std::optional<FilmMotion> Motion; // none: a picture
  std::optional<int> Frames;        // of a film; none: 120
  std::optional<int> Rate;          // frames a second; none: 25
  std::string Output;               // picture, film or directory
  SharedView Share;                 // without a path: a picture or a film
};

// Throws UserError.
Options ParseOptions(int argc, char* argv[]);

std::string HelpText();

#endif
