// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Commands_h
#define Commands_h

#include "Program/VolumeSource.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

class QMainWindow;
class QString;
class QWidget;
class Workbench;

// What a menu or a key does, beside turning a choice.
struct Command
{
  enum class Need
  {
    Nothing,
    Data,     // that are open, and a view that may change
    Surfaces, // of isovalues
    Labels,
    Steps,
    Addable,   // markers of which there may be more
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

// What asks for more in a dialog.
void AskOpen(QMainWindow& window, Workbench& bench);
void AskOpenFolder(QMainWindow& window, Workbench& bench);
void AskSaveSession(QMainWindow& window, Workbench& bench);
void AskColor(QMainWindow& window, Workbench& bench); // of the selected marker
void AskPicture(QMainWindow& window, Workbench& bench);
void AskTriangles(QMainWindow& window, Workbench& bench);
void AskSharing(QMainWindow& window, Workbench& bench);
void AskFilm(QMainWindow& window, Workbench& bench);
void AskLabelNames(QMainWindow& window, Workbench& bench);

// How the samples of a file lie that tells nothing of it; none: the dialog was left.
std::optional<RawLayout> AskRaw(QWidget& window, const QString& path);

// A window as it is seen. Throws UserError.
void SaveWindow(QWidget& window, const std::string& path);

// Mouse and keys, and what they do.
std::vector<std::pair<std::string, std::string>> AllKeys();

#endif
