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
  using Hook = std::function<void(MainWindow& window, Workbench& bench)>;

  std::function<void(CommandLine& line)> AddOptions = [](CommandLine&) {};
  Hook Begin = [](MainWindow&, Workbench&) {}; // before anything is opened
  Hook First = [](MainWindow&, Workbench&) {}; // once something is seen
};

// The Explorer as the command line says. Returns the exit status.
int RunExplorer(int argc, char* argv[], const Extension& extension = {});

// Qt aborts where no window can be opened. Throws UserError instead.
void CheckDisplay();

#endif
