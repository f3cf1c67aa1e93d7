// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Commands_h
#define Commands_h

#include <string>
#include <utility>
#include <vector>

class QMainWindow;
class Workbench;

// What a menu or a key does, beside turning a choice.
struct Command
{
  enum class Need
  {
    Nothing,
    Data, // that are open, and a view that may change
    Steps,
    Removable, // a marker that can be removed
    Undo,
    Redo,
  };

  const char* Menu;
  const char* Name;
  const char* Keys; // the first is shown; may be none
  const char* Help;
  Need Needs;
  void (*Do)(QMainWindow& window, Workbench& bench);
};
const std::vector<Command>& AllCommands();

// Mouse and keys, and what they do.
std::vector<std::pair<std::string, std::string>> AllKeys();

#endif
