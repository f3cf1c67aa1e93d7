// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MainWindow_h
#define MainWindow_h

#include "Panels/HistogramPanel.h"
#include "Work/Actions.h"
#include "Work/Workbench.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QMainWindow>

#include <map>

class QLabel;
class QProgressBar;
class QVTKOpenGLNativeWidget;

// The view, with menus and docks around it.
class MainWindow : public QMainWindow
{
public:
  explicit MainWindow(Workbench& bench);

  QVTKOpenGLNativeWidget* View() { return this->Picture; }
  HistogramPanel* Histogram() { return this->Samples; }
  void LogPlaces(); // of parts of the window, for scripts

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  void MakeMenus();
  void MakeDocks();
  QDockWidget* AddDock(
    Qt::DockWidgetArea area, const QString& name, QWidget* panel, bool isWhole = false);
  void Perform(Do what);
  void PerformOnFiles(Do what);
  void AddRecent(const QString& path);
  void ShowRecent(QMenu* menu);
  void ShowState();
  bool OnViewEvent(QEvent* event);

  Workbench& Bench;
  QVTKOpenGLNativeWidget* Picture;
  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  HistogramPanel* Samples;
  QDockWidget* Keys = nullptr;
  QDockWidget* Time = nullptr;
  QMenu* ViewMenu = nullptr;
  QLabel* Sentence;
  QProgressBar* Progress;
  QWidget* StopButton;
  std::map<Do, QAction*> Actions;
  std::map<QString, QPoint> Places; // as they were told last
};

#endif
