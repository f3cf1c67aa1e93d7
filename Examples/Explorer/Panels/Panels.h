// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Panels_h
#define Panels_h

#include <QList>

class Form;
class QAction;
class QWidget;
class Workbench;

// The parts of the window beside the view. Each shows the model's state when that changes.
// buttons: beside the table; colors: what a double click on a colour does, and more; names: asks
// for a file with names of labels.
QWidget* MakeMarkersPanel(
  Workbench& bench, const QList<QAction*>& buttons, const QList<QAction*>& colors, QAction* names);
// Parts of that panel.
void AddLabels(Form& form, Workbench& bench, QAction* names);
void AddArrayColors(Form& form, Workbench& bench);
QWidget* MakeLightPanel(Workbench& bench);
QWidget* MakeClippingPanel(Workbench& bench);
QWidget* MakeScenePanel(Workbench& bench); // what is beside the volume, and pictures
QWidget* MakeReusePanel(Workbench& bench);
QWidget* MakeStatistics(Workbench& bench); // of the last 200 frames
QWidget* MakeTimePanel(Workbench& bench);
QWidget* MakeDataPanel(Workbench& bench);

#endif
