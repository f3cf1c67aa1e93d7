// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include "Program/CommandLine.h"

#include <string>

struct Options : CommonOptions
{
  std::string SessionFile = "explorer.session"; // to save to and to restore from
  bool StartsWithSession = false;
  std::string OutputDirectory = "."; // of pictures and recordings
  std::string Log;                   // a file; empty: none
  std::string Screenshot;            // draw the window once, into this file
  int MeasuredDrag = 0;              // frames; 0: none
};

// Throws UserError.
Options ParseOptions(int argc, char* argv[]);

std::string HelpText();

#endif
