// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScriptLog_h
#define ScriptLog_h

#include "Window/MainWindow.h"

#include <fstream>
#include <map>
#include <string>

// Tells scripts what the Explorer does and where its widgets are: a line for each frame, sentence,
// setting and place, written at once.
class ScriptLog : public QObject
{
public:
  ScriptLog(const std::string& path, MainWindow& window, Workbench& bench);

protected:
  // Scripts press Shift, which does nothing, to know that all before was dealt with.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void Tell(const std::string& name, const std::string& value);
  void TellFrame(double windowMs);
  void TellChoices();
  void TellPlaces();
  void TellPlace(const QString& name, const QWidget* widget, const QPoint& place);

  MainWindow& Window;
  Workbench& Bench;
  std::ofstream File;
  int Frames = 0;
  Look Told;
  std::map<QString, QPoint> Places; // as they were told last
};

#endif
