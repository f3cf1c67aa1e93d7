// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// What MainWindow does with menus, keys and dropped files.
#include "Window/Dialogs.h"
#include "Window/MainWindow.h"

#include <vtkCamera.h>

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QSettings>
#include <QTabBar>
#include <QToolButton>

#include <utility>

namespace
{

constexpr int MostRecent = 10;

std::string PathOf(const QString& text)
{
  return QFile::encodeName(text).toStdString();
}

}

void MainWindow::Perform(Do what)
{
  Workbench& bench = this->Bench;
  switch (what)
  {
    case Do::Quit:
      this->close();
      break;
    case Do::Undo:
      bench.Changes.undo();
      break;
    case Do::Redo:
      bench.Changes.redo();
      break;
    case Do::AddSurface:
      bench.BeginGesture();
      bench.Edit(tr("surface"),
        [&](Look& look)
        {
          const auto& range = bench.Data.Counted().Range;
          Surface surface = look.Surfaces[bench.Selected()];
          surface.Isovalue +=
            (surface.Isovalue < 0.5 * (range[0] + range[1]) ? 0.2 : -0.2) * (range[1] - range[0]);
          look.Surfaces.push_back(surface);
        });
      bench.Select(bench.Data.Settings().Surfaces.size() - 1);
      break;
    case Do::RemoveSurface:
      bench.BeginGesture();
      bench.Edit(tr("surface"),
        [&](Look& look)
        { look.Surfaces.erase(look.Surfaces.begin() + static_cast<long>(bench.Selected())); });
      break;
    case Do::Clip:
      this->findChild<QAbstractButton*>("clip")->click();
      break;
    case Do::Crop:
      this->findChild<QAbstractButton*>("crop")->click();
      break;
    case Do::ResetView:
      bench.Data.ResetView();
      bench.RenderSoon();
      break;
    case Do::UpsideDown:
      bench.Data.View.Renderer->GetActiveCamera()->Roll(180.0);
      bench.RenderSoon();
      break;
    case Do::FullScreen:
      this->setWindowState(this->windowState() ^ Qt::WindowFullScreen);
      break;
    case Do::BuildIsomap:
      bench.BuildIsomap();
      break;
    case Do::NextArray:
      bench.Ask([&] { return bench.Data.NextArrayOfFile(); });
      break;
    case Do::EarlierStep:
    case Do::LaterStep:
      bench.Ask(
        [&]
        {
          const int step = bench.Data.State().Source.TimeStep;
          return bench.Data.OtherTimeStep(what == Do::LaterStep ? step + 1 : step - 1);
        });
      break;
    case Do::Play:
      this->findChild<QToolButton*>("play")->toggle();
      break;
    case Do::Stop:
      bench.Cancel();
      this->setWindowState(this->windowState() & ~Qt::WindowFullScreen);
      break;
    case Do::Keys:
      this->Keys->setVisible(!this->Keys->isVisible());
      bench.Log.Event("help", this->Keys->isVisible() ? "on" : "off");
      break;
    default:
      this->PerformOnFiles(what);
  }
}

void MainWindow::PerformOnFiles(Do what)
{
  Workbench& bench = this->Bench;
  const QString directory =
    QFileInfo(QFile::decodeName(bench.Data.State().Source.Path.c_str())).absolutePath();
  const auto open = [&](const QString& path)
  {
    if (!path.isEmpty())
    {
      bench.OpenPath(PathOf(path));
    }
  };
  switch (what)
  {
    case Do::Open:
      open(QFileDialog::getOpenFileName(this, tr("Open a volume or a session"), directory));
      break;
    case Do::OpenFolder:
      open(QFileDialog::getExistingDirectory(this, tr("Open a folder of DICOM files"), directory));
      break;
    case Do::SaveSession:
      bench.SaveSession(bench.SessionFile);
      break;
    case Do::SaveSessionAs:
    {
      const QString path = QFileDialog::getSaveFileName(
        this, tr("Save the session"), "explorer.session", tr("Sessions (*.session)"));
      if (!path.isEmpty())
      {
        bench.SaveSession(PathOf(path.endsWith(".session") ? path : path + ".session"));
      }
      break;
    }
    case Do::Restore:
      bench.OpenPath(bench.SessionFile);
      break;
    case Do::Picture:
      bench.SavePicture();
      break;
    case Do::PictureAs:
      AskPicture(this, bench);
      break;
    case Do::WindowPicture:
      bench.Try([&] { bench.Say("Saved " + bench.Output.Save(PictureOf(this))); });
      break;
    case Do::Record:
      bench.ToggleRecording();
      break;
    case Do::Film:
      AskFilm(this, bench);
      break;
    default:
      break;
  }
}

void MainWindow::AddRecent(const QString& path)
{
  QSettings settings;
  QStringList recent = settings.value("recent").toStringList();
  const QString whole = QFileInfo(path).absoluteFilePath();
  recent.removeAll(whole);
  recent.prepend(whole);
  settings.setValue("recent", QStringList(recent.mid(0, MostRecent)));
}

void MainWindow::ShowRecent(QMenu* menu)
{
  menu->clear();
  for (const QString& path : QSettings().value("recent").toStringList())
  {
    // An ampersand would be a shortcut.
    QAction* item = menu->addAction(QFileInfo(path).fileName().replace('&', "&&"),
      [this, path] { this->Bench.OpenPath(PathOf(path)); });
    item->setToolTip(path);
    item->setStatusTip(path);
    item->setEnabled(QFileInfo::exists(path));
  }
}

// The view's events, before VTK sees them: true for those that it is not to see.
bool MainWindow::OnViewEvent(QEvent* event)
{
  switch (event->type())
  {
    case QEvent::KeyPress:
    {
      const int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down)
      {
        QApplication::sendEvent(this->Samples, event);
      }
      return key != Qt::Key_Tab && key != Qt::Key_Backtab;
    }
    case QEvent::DragEnter:
    case QEvent::DragMove:
    case QEvent::Drop:
    {
      auto* drop = static_cast<QDropEvent*>(event);
      const QList<QUrl> urls = drop->mimeData()->urls();
      if (!urls.isEmpty() && urls.front().isLocalFile())
      {
        drop->acceptProposedAction();
        if (event->type() == QEvent::Drop)
        {
          this->Bench.OpenPath(PathOf(urls.front().toLocalFile()));
        }
      }
      return true;
    }
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonDblClick:
    case QEvent::Wheel:
      // It is drawn no more than its picture is changed.
      return this->Bench.IsBuilding() || !this->Bench.Data.IsOpen();
    default:
      return false;
  }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->Picture)
  {
    return this->OnViewEvent(event);
  }
  if (watched == this && event->type() >= QEvent::DragEnter && event->type() <= QEvent::Drop)
  {
    return this->OnViewEvent(event);
  }
  // Scripts press Shift, which does nothing, to know that all before was dealt with.
  if (event->type() == QEvent::KeyPress && !this->Bench.Chosen.Log.empty() &&
    watched->isWindowType() && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Shift)
  {
    if (this->Bench.IsRenderDue())
    {
      this->Bench.Render();
    }
    this->LogPlaces();
    this->Bench.Log.Event(this->Bench.IsBusy() ? "key-while-busy" : "key", "Shift_L");
  }
  return false;
}

void MainWindow::LogPlaces()
{
  const auto tell = [this](const QString& name, const QWidget* widget, const QPoint& place)
  {
    const QPoint point = widget->mapTo(widget->window(), place) * this->devicePixelRatioF();
    if (std::exchange(this->Places[name], point) != point)
    {
      this->Bench.Log.Place(name.toStdString(), point.x(), point.y());
    }
  };
  tell("isovalue-least", this->Samples, this->Samples->PlaceOf(0.0));
  tell("isovalue-greatest", this->Samples, this->Samples->PlaceOf(1.0));
  tell("view-middle", this->Picture, this->Picture->rect().center());
  for (const QTabBar* tabs : this->findChildren<QTabBar*>())
  {
    for (int i = 0; i < tabs->count(); ++i)
    {
      tell("tab-" + tabs->tabText(i), tabs, tabs->tabRect(i).center());
    }
  }
  for (const QWidget* widget : this->findChildren<QWidget*>())
  {
    const QString name = widget->objectName();
    if (!name.isEmpty() && !name.startsWith("qt_") && widget->window() == this &&
      !widget->visibleRegion().isEmpty())
    {
      // Boxes to tick are where their rows begin.
      const QPoint middle = widget->rect().center();
      tell(name, widget, { std::min(middle.x(), middle.y()), middle.y() });
    }
  }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  this->Bench.Cancel();
  if (this->Bench.Output.IsRecording())
  {
    this->Bench.ToggleRecording();
  }
  if (this->Bench.Chosen.Log.empty())
  {
    QSettings().setValue("window", this->saveState());
  }
  this->Bench.Log.Event("quit", "");
  event->accept();
}
