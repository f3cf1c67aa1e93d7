// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Dialogs_h
#define Dialogs_h

#include <string>

class QMainWindow;
class QWidget;
class Workbench;

void AskOpen(QMainWindow& window, Workbench& bench);
void AskOpenFolder(QMainWindow& window, Workbench& bench);
void AskSaveSession(QMainWindow& window, Workbench& bench);
void AskColor(QMainWindow& window, Workbench& bench); // of the selected marker
void AskPicture(QMainWindow& window, Workbench& bench);
void AskFilm(QMainWindow& window, Workbench& bench);
void SavePictureOfWindow(QMainWindow& window, Workbench& bench);

// A window as it is seen. Throws UserError.
void SaveWindow(QWidget& window, const std::string& path);

#endif
