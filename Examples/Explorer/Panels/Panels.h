// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Panels_h
#define Panels_h

#include "Model/Choices.h"

#include <QColor>
#include <QPalette>
#include <QString>

#include <array>
#include <functional>
#include <vector>

class QAction;
class QWidget;
class Workbench;

// The parts of the window beside the view. Each shows the model's state when that changes.
QWidget* MakeSurfacesPanel(Workbench& bench, const std::vector<QAction*>& actions);
QWidget* MakeLightPanel(Workbench& bench);
QWidget* MakeClippingPanel(Workbench& bench);
QWidget* MakeReusePanel(Workbench& bench);
QWidget* MakeStatistics(Workbench& bench); // of the last 200 frames
QWidget* MakeTimePanel(Workbench& bench);
QWidget* MakeDataPanel(Workbench& bench);

// What they share.
QColor ColorOf(const std::array<double, 3>& rgb);
QColor Blended(const QPalette& palette, double share); // between ground and text
QString Short(double number);                          // with as many digits as tell values apart
void AskColor(QWidget* over, const QColor& first,
  const std::function<void(const std::array<double, 3>&)>& take);

#endif
