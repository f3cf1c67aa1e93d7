// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include <array>
#include <optional>
#include <stdexcept>
#include <string>

// A mistake of the user's: one sentence that names it and says what to do.
class UserError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// What a file of bare samples does not tell itself.
struct RawLayout
{
  std::array<int, 3> Dimensions = { 0, 0, 0 };
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
  int ScalarType = 0; // VTK_UNSIGNED_CHAR, ...
};

struct Options
{
  std::string Volume; // file or directory; empty: the generated spheres
  int Spheres = 256;  // samples along an axis of the generated volume
  std::optional<RawLayout> Raw;
  bool BigEndian = false; // of raw samples
  std::optional<double> Isovalue;
  bool ThresholdMode = false; // THRESHOLD instead of CROSSING

  int Width = 1024;
  int Height = 1024;
  int OrbitFrames = 30;
  int SweepFrames = 24;
  int ColorFrames = 6;
  int RepeatFrames = 10;
  int FramesWithoutReuse = 4; // three times in a tour
  std::string From; // "+y": the viewer's place, seen from the middle; empty: what suits the file
  std::string Up = "+z";

  std::string OutputDirectory = "pictures";
  bool Interactive = false;
  std::string Screenshot; // render the interactive window once, into this file
  bool Help = false;
};

// Throws UserError.
Options ParseOptions(int argc, char* argv[]);

const char* HelpText();

#endif
