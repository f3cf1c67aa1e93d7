// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// The Explorer's model, its work beside the window, and its widgets, by simulated events. Nothing
// waits for a time: what is to happen is waited for.
#ifndef ExplorerTests_h
#define ExplorerTests_h

#include "Window/MainWindow.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <memory>
#include <string>

constexpr int Width = 160, Height = 120; // of pictures
constexpr int Spheres = 32;
constexpr int Patience = 60000; // ms until what has not happened is a failure

Session SmallSession();
void SetNumbers(Look& look, Row::Which first, const std::vector<double>& values);
bool AreSame(vtkImageData* a, vtkImageData* b);
void Write(const QString& path, const std::string& text);
std::string TextOf(const QString& path);
std::string TimeSeries(); // a tetrahedron whose values rise with time

class ExplorerTests : public QObject
{
  Q_OBJECT

private slots:
  void initTestCase();
  void init();
  void cleanup();

  void ASessionOfVersion01GivesTheSamePicture();
  void SessionsAreRepeated();
  void AveragesAndSumsAreBright();
  void SettingsAreFitted();
  void OldSessionsAreAsTheyWere();
  void WaysToDrawDiffer();
  void PresetsAndShift();
  void ProjectionsAreGrey();
  void TheCutShowsSamples();
  void LabelsHaveNames();
  void NamesOfAllKindsAreRead();
  void SessionsMoveWithTheirVolumes();

  void ArraysColorSurfaces();
  void ArrayColorsAreKept();
  void RangesOfArraysAreWide();

  void TheWindowAnswersWhileReading();
  void TheLatestFileIsOpened();
  void TheWindowAnswersWhileAnIsomapIsBuilt();
  void SettingsWaitForTheIsomap();
  void ChangesAreUndone();
  void WhatCannotBeOpenedIsTold();
  void TimeStepsArePlayed();
  void PicturesGetBetter();
  void PicturesAndFilmsAreFinal();
  void KeysWorkOnceAPictureIsSaved();
  void VolumesAreMadeInParts();
  void ClicksOfTheWheelAreJoined();
  void TrianglesAreExported();
  void ViewsAreShared();

  void TheHistogramMovesIsovalues();
  void TheHistogramMovesOpacities();
  void TheHistogramIsZoomed();
  void FilesOfSamplesAloneAreAskedFor();
  void TheTableChangesSurfaces();
  void TheListChangesLabels();
  void PanelsShowTheModel();
  void ClippingAndCropping();
  void PicturesHaveAnnotations();
  void ThePointerTellsWhatIsThere();
  void MenusHaveTicks();
  void DistancesAreMeasured();
  void ViewsAreRemembered();
  void KeysOfVersion01();
  void KeyboardAlone();
  void NothingIsCutOff();
  void NamesOfAllScripts();

private:
  void Open(const Session& session);
  void OpenLabels(); // 1, 2 and 30, of which a file tells names

  QTemporaryDir Directory;
  std::unique_ptr<Workbench> Bench;
  std::unique_ptr<MainWindow> Window;
};

#endif
