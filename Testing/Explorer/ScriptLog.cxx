// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScriptLog.h"

#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QTabBar>

#include <algorithm>
#include <utility>

ScriptLog::ScriptLog(const std::string& path, MainWindow& window, Workbench& bench)
  : QObject(&window)
  , Window(window)
  , Bench(bench)
  , File(path)
{
  if (!this->File)
  {
    throw UserError(Quoted(path) + " cannot be written; name another file with --log.");
  }
  qApp->installEventFilter(this);
  QObject::connect(&bench, &Workbench::FrameDrawn, this, &ScriptLog::TellFrame);
  QObject::connect(&bench, &Workbench::Changed, this, &ScriptLog::TellChoices);
  QObject::connect(&bench, &Workbench::Said, this,
    [this](const QString& sentence) { this->Tell("said", sentence.toStdString()); });
  QObject::connect(&bench, &Workbench::Opened, this,
    [this](bool isOtherFile)
    {
      const Model& model = this->Bench.Data;
      this->Told = model.Settings();
      this->Tell(
        isOtherFile ? "opened" : "shown", isOtherFile ? model.Data().Name : model.Description());
    });
  QObject::connect(window.findChild<QDockWidget*>("Keys")->toggleViewAction(), &QAction::toggled,
    this, [this](bool isOn) { this->Tell("help", isOn ? "on" : "off"); });
}

void ScriptLog::Tell(const std::string& name, const std::string& value)
{
  this->File << name << ' ' << Printable(value) << std::endl;
}

void ScriptLog::TellFrame(double windowMs)
{
  if (this->Bench.Refiner->GetRendering())
  {
    return; // it shows what was seen before, but better
  }
  vtkTemporalCoherenceVolumeMapper* mapper = this->Bench.Data.View.Mapper;
  const double rays =
    std::max(1.0, static_cast<double>(mapper->GetStatistics()->GetNumberOfRays()));
  this->File << "frame " << ++this->Frames << " route "
             << mapper->GetStatistics()->GetRouteAsString() << " isovalue "
             << *this->Bench.Data.State().Isovalue << " ms " << windowMs << " mapper "
             << 1000.0 * mapper->GetStatistics()->GetFrameTime() << " traced "
             << static_cast<double>(mapper->GetStatistics()->GetNumberOfTracedRays()) / rays
             << " isomap " << mapper->GetStatistics()->GetIsomapMemory() << std::endl;
}

void ScriptLog::TellChoices()
{
  const Look& look = this->Bench.Data.Settings();
  for (std::size_t i = 0; i < Row::Count; ++i)
  {
    if (AllSettings()[i].Key && look.Values[i] != this->Told.Values[i])
    {
      this->Tell(AllSettings()[i].Name, look.TextOf(static_cast<Row::Which>(i)));
    }
  }
  this->Told = look;
}

void ScriptLog::TellPlace(const QString& name, const QWidget* widget, const QPoint& place)
{
  const QPoint point = widget->mapTo(widget->window(), place) * this->Window.devicePixelRatioF();
  if (std::exchange(this->Places[name], point) != point)
  {
    this->File << "place " << Printable(name.toStdString()) << ' ' << point.x() << ' ' << point.y()
               << std::endl;
  }
}

void ScriptLog::TellPlaces()
{
  const HistogramPanel* histogram = this->Window.Histogram();
  this->TellPlace("isovalue-least", histogram, histogram->PlaceOf(0.0));
  this->TellPlace("isovalue-greatest", histogram, histogram->PlaceOf(1.0));
  this->TellPlace("view-middle", this->Window.View(), this->Window.View()->rect().center());
  for (const QTabBar* tabs : this->Window.findChildren<QTabBar*>())
  {
    for (int i = 0; i < tabs->count(); ++i)
    {
      this->TellPlace("tab-" + tabs->tabText(i), tabs, tabs->tabRect(i).center());
    }
  }
  for (const QWidget* widget : this->Window.findChildren<QWidget*>())
  {
    const QString name = widget->objectName();
    if (!name.isEmpty() && !name.startsWith("qt_") && widget->window() == &this->Window &&
      !widget->visibleRegion().isEmpty())
    {
      // Boxes to tick are where their rows begin.
      const QPoint middle = widget->rect().center();
      this->TellPlace(name, widget, { std::min(middle.x(), middle.y()), middle.y() });
    }
  }
}

bool ScriptLog::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == &this->Window && event->type() == QEvent::Close)
  {
    this->Tell("quit", "");
  }
  if (event->type() == QEvent::KeyPress && watched->isWindowType() &&
    static_cast<QKeyEvent*>(event)->key() == Qt::Key_Shift)
  {
    if (this->Bench.IsRenderDue())
    {
      this->Bench.Render();
    }
    this->TellPlaces();
    this->Tell(this->Bench.IsBusy() ? "key-while-busy" : "key", "Shift_L");
  }
  return false;
}
