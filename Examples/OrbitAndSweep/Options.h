// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include "Program/CommandLine.h"

#include <string>

struct Options : CommonOptions
{
  int OrbitFrames = 30;
  int SweepFrames = 48;
  int ColorFrames = 6;
  int RepeatFrames = 10;
  int FramesWithoutReuse = 4; // three times in a tour
  std::string OutputDirectory = "pictures";
};

// Throws UserError.
Options ParseOptions(int argc, char* argv[]);

std::string HelpText();

#endif
