// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MainWindow_h
#define MainWindow_h

#include "Panels/HistogramPanel.h"
#include "Work/Workbench.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QMainWindow>

#include <map>

class QLabel;
class QProgressBar;
class QToolButton;
class QVTKOpenGLNativeWidget;

// The view, with menus and docks around it.
class MainWindow : public QMainWindow
{
public:
  explicit MainWindow(Workbench& bench);

  // As large as it was last, or so that the screen holds it; and from now on, a file is seen as it
  // was when it was left.
  void TakeUpLast();

  QVTKOpenGLNativeWidget* View() { return this->Picture; }
  HistogramPanel* Histogram() { return this->Samples; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  void MakeView();
  void MakeMenus();
  void MakeSettingsMenu(QMenu* menu);
  void AddChoiceMenu(QMenu* menu, const Setting& choice);
  void MakeDocks();
  QDockWidget* AddDock(Qt::DockWidgetArea area, const QString& name, QWidget* panel, bool isWhole);
  void MakeStatusBar();
  void ShowRecent(QMenu* menu);
  void OnOpened();
  void KeepView();
  void RecallView();
  void ShowUnderPointer();
  void ShowState();
  void ShowProgress();

  Workbench& Bench;
  QVTKOpenGLNativeWidget* Picture;
  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  HistogramPanel* Samples;
  QDockWidget* Time = nullptr;
  QLabel* Sentence;
  QLabel* UnderPointer;
  QProgressBar* Progress;
  QToolButton* StopButton;
  QPoint Pointer; // in the view
  QTimer Pointing;
  bool RemembersViews = false;
  double Refined = 1.0; // of the picture; 1: it is final
  std::map<QString, QMenu*> Menus;
  std::map<QString, QAction*> Actions; // by their names, without ampersands
};

#endif
