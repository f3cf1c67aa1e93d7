// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include "Model/Settings.h"
#include "Program/CommandLine.h"
#include "View/Viewpoint.h"

#include <optional>
#include <string>
#include <vector>

struct Options : CommonOptions
{
  // What is drawn of the values: Drawing is a word of Row::Drawing.
  std::string Drawing = "surfaces";
  std::vector<double> Isovalues; // none: one is chosen
  std::vector<double> Opacities; // none, one for all, or one for each isovalue
  std::vector<Rgb> Colors;       // as well
  std::string Preset;            // of composite volumes
  std::optional<double> Shift;
  std::optional<double> Window, Level; // of projections
  bool HasOcclusion = false, HasShadows = false;

  // From where, and how much of it.
  double Azimuth = 0.0;              // degrees
  double Elevation = UsualElevation; // as well
  double Zoom = 1.0;
  bool IsParallel = false;
  struct Cut
  {
    std::string Axis; // "+x": what lies beyond is hidden
    double Value = 0.0;
    bool IsShare = false; // of the volume's bounds
  };
  std::optional<Cut> Clip;

  // The picture.
  int Samples = 1;               // rays along the width and the height of a pixel
  std::optional<Rgb> Background; // none: dark
  bool IsTransparent = false;
  std::string Film; // "turn", "sweep"; empty: one picture
  std::optional<int> Frames, Rate;
  std::string Output; // empty: a name like that of the volume
  bool WantsVersion = false;

  bool DrawsSurfaces() const { return this->Drawing == "surfaces"; }
  bool IsFilm() const { return !this->Film.empty(); }
};

// Throws UserError.
Options ParseOptions(int argc, char* argv[]);

std::string HelpText();

#endif
