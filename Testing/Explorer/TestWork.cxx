// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The Explorer answers while it reads and builds. Pictures get better while nothing is done, and
// those that are saved are final. Changes can be undone, and a message says what cannot be opened.

#include "ExplorerTests.h"

#include <QAbstractButton>
#include <QAction>
#include <QLabel>
#include <QProgressBar>
#include <QSlider>
#include <QVTKOpenGLNativeWidget.h>
#include <QWheelEvent>

#include <algorithm>
#include <set>

// Opening comes back at once; what is read is seen when the event loop has run.
void ExplorerTests::TheWindowAnswersWhileReading()
{
  Session session = SmallSession();
  session.Source.Spheres = 2 * Spheres;
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  this->Bench->Open(session);
  QVERIFY(this->Bench->IsBusy());
  QCOMPARE(this->Bench->Data.State().Source.Spheres, Spheres);
  // Meanwhile what is shown is drawn, and changed.
  QSignalSpy frames(this->Bench.get(), &Workbench::FrameDrawn);
  this->Bench->Turn(Row::Palette, 1);
  this->Bench->Render();
  QCOMPARE(frames.count(), 1);
  QVERIFY(opened.wait(Patience));
  QVERIFY(!this->Bench->IsBusy());
  QCOMPARE(this->Bench->Data.State().Source.Spheres, 2 * Spheres);
}

void ExplorerTests::TheLatestFileIsOpened()
{
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  for (const int size : { 20, 24, 28 })
  {
    Session session = SmallSession();
    session.Source.Spheres = size;
    this->Bench->Open(session);
  }
  QVERIFY(opened.wait(Patience));
  QCOMPARE(opened.count(), 1);
  QCOMPARE(this->Bench->Data.State().Source.Spheres, 28);
}

void ExplorerTests::TheWindowAnswersWhileAnIsomapIsBuilt()
{
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  this->Bench->BuildIsomap();
  QVERIFY(this->Bench->IsBusy());
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QVERIFY(said.last()[0].toString().contains("is built"));
  // Stopped before the event loop has run, so before it can be done.
  this->Bench->Turn(Row::Surface, 1);
  this->Bench->BuildIsomap();
  this->Bench->Cancel();
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QVERIFY(said.last()[0].toString().contains("was stopped"));
}

void ExplorerTests::SettingsWaitForTheIsomap()
{
  std::set<std::string> routes; // the window may be drawn again when the bar goes
  QObject::connect(this->Bench.get(), &Workbench::FrameDrawn, this->Window.get(),
    [&] { routes.insert(this->Bench->Data.View.Mapper->GetStatistics()->GetRouteAsString()); });
  this->Bench->BuildIsomap();
  this->Bench->Edit("isovalue", [](Look& look) { look.Surfaces[0].Value = 77.0; });
  QCOMPARE(*this->Bench->Data.State().Isovalue, 77.0);
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QVERIFY(routes.count("IsomapLookup") == 1);
  this->cleanup(); // nothing is to hear of frames any more
}

void ExplorerTests::ChangesAreUndone()
{
  const double before = *this->Bench->Data.State().Isovalue;
  this->Bench->BeginGesture();
  for (const double value : { 50.0, 60.0, 70.0 })
  {
    this->Bench->Edit("isovalue", [=](Look& look) { look.Surfaces[0].Value = value; });
  }
  this->Bench->Turn(Row::Light, 1);
  QCOMPARE(this->Bench->Changes.count(), 2);
  this->Bench->Changes.undo();
  QCOMPARE(this->Bench->Data.Settings().Values[Row::Light], 0.0);
  QCOMPARE(*this->Bench->Data.State().Isovalue, 70.0);
  this->Bench->Changes.undo();
  QCOMPARE(*this->Bench->Data.State().Isovalue, before);
  this->Bench->Changes.redo();
  QCOMPARE(*this->Bench->Data.State().Isovalue, 70.0);
}

void ExplorerTests::WhatCannotBeOpenedIsTold()
{
  Write(this->Directory.filePath("broken.vti"), "This is no XML.");
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  this->Bench->OpenPath(this->Directory.filePath("broken.vti"));
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QCOMPARE(said.count(), 1);
  QVERIFY(said[0][0].toString().contains("could not be read"));
  QVERIFY(said[0][1].toBool());
  QCOMPARE(
    this->Window->findChild<QLabel*>("sentence")->text(), QChar(0x200e) + said[0][0].toString());
  QCOMPARE(this->Bench->Data.State().Source.Spheres, Spheres);
}

void ExplorerTests::TimeStepsArePlayed()
{
  Session session;
  session.Source.Path = this->Directory.filePath("series.vtu").toStdString();
  Write(this->Directory.filePath("series.vtu"), TimeSeries());
  this->Open(session);
  QCOMPARE(this->Bench->Data.Data().TimeSteps, 3);
  auto* slider = this->Window->findChild<QSlider*>("time");
  QVERIFY(slider->isVisible());
  QCOMPARE(slider->maximum(), 3);
  slider->setValue(3);
  QTRY_COMPARE_WITH_TIMEOUT(this->Bench->Data.State().Source.TimeStep, 3, Patience);
  QCOMPARE(this->Bench->Data.Counted().Range[1], 120.0);
  // Round and round, until it is paused.
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  auto* play = this->Window->findChild<QAbstractButton*>("play");
  play->click();
  QTRY_VERIFY_WITH_TIMEOUT(opened.count() >= 4, Patience);
  play->click();
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
}

// With ambient occlusion, until it is done; a bar tells how far it is.
void ExplorerTests::PicturesGetBetter()
{
  Session session;
  session.Source.Spheres = Spheres;
  QVERIFY(session.Settings.Values[Row::Occlusion] != 0.0);
  QSignalSpy refined(this->Bench.get(), &Workbench::Refined);
  this->Open(session);
  const auto* bar = this->Window->findChild<QProgressBar*>("progress");
  QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && bar->value() > 0, Patience);
  QTRY_COMPARE_WITH_TIMEOUT(this->Bench->Refiner->GetProgress(), 1.0, Patience);
  QVERIFY(this->Bench->Data.View.Mapper->GetFrameIsFinal());
  QVERIFY(refined.count() > 8);
  QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), Patience);
  // Not while something is dragged, but after it.
  this->Bench->SetDragging(true);
  this->Bench->Edit("isovalue", [](Look& look) { look.Surfaces[0].Value += 1.0; });
  this->Bench->Render();
  refined.clear();
  QTest::qWait(50);
  QCOMPARE(refined.count(), 0);
  this->Bench->SetDragging(false);
  QTRY_COMPARE_WITH_TIMEOUT(this->Bench->Refiner->GetProgress(), 1.0, Patience);
  QVERIFY(refined.count() > 8);
}

void ExplorerTests::PicturesAndFilmsAreFinal()
{
  this->Bench->Turn(Row::Occlusion, 1);
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  const QString path = this->Directory.filePath("final.png");
  this->Bench->SavePicture(path.toStdString(), Width, Height);
  QVERIFY(this->Bench->IsBusy());
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QVERIFY2(said.last()[0].toString().startsWith("Saved"), said.last()[0].toString().toUtf8());
  QVERIFY(QFile::exists(path));
  // One that is stopped is not saved, and the view goes on.
  const QString other = this->Directory.filePath("stopped.png");
  this->Bench->SavePicture(other.toStdString(), 8 * Width, 8 * Height);
  this->Bench->Cancel();
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QVERIFY2(said.last()[0].toString().contains("stopped"), said.last()[0].toString().toUtf8());
  QVERIFY(!QFile::exists(other) && this->Bench->Refiner->GetEnabled());

  const CameraState camera = this->Bench->Data.View.Camera();
  for (const auto motion : { FilmMotion::TurnAround, FilmMotion::Sweep })
  {
    Workbench::FilmOptions options;
    options.Motion = motion;
    options.Frames = 2;
    options.Width = Width / 4;
    options.Height = Height / 4;
    this->Bench->MakeFilm(options);
    QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
    QVERIFY2(
      said.last()[0].toString().startsWith("Recorded 2"), said.last()[0].toString().toUtf8());
  }
  QVERIFY(camera.Position == this->Bench->Data.View.Camera().Position);
}

// Commands that change the view are off while a picture is made, and on as soon as it is saved.
void ExplorerTests::KeysWorkOnceAPictureIsSaved()
{
  const auto actions = this->Window->findChildren<QAction*>();
  const auto turn = std::find_if(actions.begin(), actions.end(),
    [](const QAction* action) { return action->shortcut() == QKeySequence("U"); });
  QVERIFY(turn != actions.end() && (*turn)->isEnabled());
  this->Bench->SavePicture(
    this->Directory.filePath("large.png").toStdString(), 8 * Width, 8 * Height);
  emit this->Bench->Settled();
  QVERIFY(!(*turn)->isEnabled());
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QVERIFY((*turn)->isEnabled());
}

// No frame waits for all rays of a volume; the picture is final in the end, and that of one piece.
void ExplorerTests::VolumesAreMadeInParts()
{
  Session session = SmallSession();
  session.Source.Spheres = 96;
  session.Settings.Values[Row::Drawing] = 1;
  this->Open(session);
  QTRY_COMPARE_WITH_TIMEOUT(this->Bench->Refiner->GetProgress(), 1.0, Patience);
  vtkRenderWindow* window = this->Window->View()->renderWindow();
  QVERIFY(window->GetDesiredUpdateRate() > 10.0);
  const int* size = this->Bench->Data.View.Renderer->GetSize();
  QVERIFY(
    AreSame(this->Bench->Data.View.LastFrame(), this->Bench->Data.View.Picture(size[0], size[1])));
  this->Bench->Turn(Row::Drawing, -1);
  QVERIFY(window->GetDesiredUpdateRate() < 0.1);
}

void ExplorerTests::ClicksOfTheWheelAreJoined()
{
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy() && !this->Bench->IsRenderDue(), Patience);
  QTest::qWait(100);
  QSignalSpy frames(this->Bench.get(), &Workbench::FrameDrawn);
  const CameraState before = this->Bench->Data.View.Camera();
  QWidget* view = this->Window->View();
  for (int click = 0; click < 10; ++click)
  {
    const QPointF place = view->rect().center();
    QWheelEvent event(place, view->mapToGlobal(place.toPoint()), {}, QPoint(0, 120), Qt::NoButton,
      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(view, &event);
  }
  QCOMPARE(frames.count(), 0);
  QTRY_VERIFY_WITH_TIMEOUT(frames.count() > 0, Patience);
  QVERIFY(frames.count() <= 2); // the window may be drawn for another reason
  QVERIFY(before.Position != this->Bench->Data.View.Camera().Position);
}

// Of what is seen: half of it where a plane clips the other half away.
void ExplorerTests::TrianglesAreExported()
{
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  const auto count = [&](const char* name)
  {
    const QString path = this->Directory.filePath(name);
    this->Bench->ExportTriangles(path.toStdString());
    while (this->Bench->IsBusy())
    {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    const QString sentence = said.last()[0].toString();
    return QFile(path).size() > 1000 ? sentence.section(' ', -2, -2).toInt() : 0;
  };
  const int all = count("surface.stl");
  QVERIFY(all > 500);
  QCOMPARE(count("surface.ply"), all);
  QCOMPARE(count("surface.vtp"), all);
  this->Bench->Edit("clipping",
    [](Look& look)
    {
      look.Values[Row::Clipping] = 1;
      look.Clip = Plane{ { 15.5, 15.5, 15.5 }, { 1.0, 0.0, 0.0 } };
    });
  const int half = count("half.vtp");
  QVERIFY2(half > all / 4 && half < 3 * all / 4, std::to_string(half).c_str());
  QCOMPARE(count("surface.obj"), 0);
  QVERIFY(said.last()[0].toString().contains(".stl"));
  this->Bench->Edit("surface", [](Look& look) { look.Surfaces[0].IsVisible = false; });
  QCOMPARE(count("none.stl"), 0);
  QVERIFY(said.last()[0].toString().contains("no surface"));
}

// A page with a picture and a view file in it; stopped, or refused, there is none.
void ExplorerTests::ViewsAreShared()
{
  this->Open(SmallSession());
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  const auto share = [&](const char* name, bool isStopped = false)
  {
    SharedView wanted;
    wanted.Path = this->Directory.filePath(name).toStdString();
    wanted.Title = "Four <spheres>";
    wanted.Width = wanted.Height = 64;
    this->Bench->Share(wanted);
    if (isStopped)
    {
      this->Bench->Cancel();
    }
    while (this->Bench->IsBusy())
    {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    QFile file(this->Directory.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  };
  const QByteArray page = share("view.html");
  QVERIFY(said.last()[0].toString().startsWith("Shared: "));
  QVERIFY(said.last()[0].toString().endsWith("open it with a browser"));
  QVERIFY(page.startsWith("<!DOCTYPE html>"));
  QVERIFY(page.contains("<title>Four &lt;spheres&gt;</title>"));
  QVERIFY(share("view.tcview").startsWith("TCVIEW"));
  QVERIFY(share("view.png").isEmpty());
  QVERIFY(said.last()[0].toString().contains(".tcview"));
  QVERIFY(share("stopped.html", true).isEmpty());
}
