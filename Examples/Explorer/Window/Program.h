// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Program_h
#define Program_h

#include "Program/CommandLine.h"

#include <functional>

class MainWindow;
class Workbench;

// What tests add to the program.
struct Extension
{
  std::function<void(CommandLine& line)> AddOptions;
  std::function<void(MainWindow& window, Workbench& bench)> Begin; // before anything is opened
  std::function<void(MainWindow& window, Workbench& bench)> First; // once something is seen
};

// The Explorer as the command line says. Returns the exit status.
int RunExplorer(int argc, char* argv[], const Extension& extension = {});

// Qt aborts where no window can be opened. Throws UserError instead.
void CheckDisplay();

#endif
