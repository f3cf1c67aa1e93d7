// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StallMeasurement.h"

#include "Mouse.h"
#include "Window/MainWindow.h"

#include <vtkTimerLog.h>

#include <QApplication>
#include <QVTKOpenGLNativeWidget.h>
#include <QWheelEvent>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>

namespace
{

constexpr double RestAfter = 0.3; // seconds without a frame: all that follows is done
constexpr int Clicks = 10;        // of the wheel
constexpr int Steps = 20;         // of a drag

// The longest time between two turns of the event loop while it lives.
class LoopWatch
{
public:
  explicit LoopWatch(Workbench& bench)
  {
    QObject::connect(&this->Ticks, &QTimer::timeout, [this] { this->Tick(); });
    QObject::connect(&bench, &Workbench::FrameDrawn, &this->Ticks,
      [this, &bench](double ms)
      {
        if (ms > this->LongestFrame)
        {
          this->LongestFrame = ms;
          this->Route = bench.Data.View.Mapper->GetStatistics()->GetRouteAsString();
        }
        ++this->Frames;
        this->LastFrame = vtkTimerLog::GetUniversalTime();
      });
    this->Ticks.start(0);
  }

  // Until no more frames come.
  void Wait()
  {
    this->LastFrame = vtkTimerLog::GetUniversalTime();
    while (vtkTimerLog::GetUniversalTime() - this->LastFrame < RestAfter)
    {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
  }

  double Longest = 0.0, LongestFrame = 0.0; // ms
  std::string Route;                        // of that frame
  int Frames = 0;

private:
  void Tick()
  {
    const double now = vtkTimerLog::GetUniversalTime();
    this->Longest = std::max(this->Longest, 1000.0 * (now - this->Last));
    this->Last = now;
  }

  QTimer Ticks;
  double Last = vtkTimerLog::GetUniversalTime(), LastFrame = Last;
};

void SendWheel(QWidget* view)
{
  const QPointF place = view->rect().center();
  auto* event = new QWheelEvent(place, view->mapToGlobal(place.toPoint()), {}, QPoint(0, 120),
    Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::postEvent(view, event); // as a wheel's clicks come: without waiting
}

}

void MeasureStalls(MainWindow& window, Workbench& bench)
{
  QWidget* const view = window.View();
  const auto measure = [&](const std::string& what, const std::function<void()>& action)
  {
    LoopWatch watch(bench);
    action();
    watch.Wait();
    std::printf("%-24s %6.0f ms, %d frames, at most %.0f ms (%s), %s\n", what.c_str(),
      watch.Longest, watch.Frames, watch.LongestFrame, watch.Route.c_str(),
      bench.Data.View.Mapper->GetFrameIsFinal() ? "final" : "NOT FINAL");
  };
  std::printf("The longest time that an event waited:\n");
  measure("first", [] {});
  const std::vector<const char*>& drawings = AllSettings()[Row::Drawing].Words;
  for (std::size_t drawing = 1; drawing < drawings.size(); ++drawing)
  {
    measure(drawings[drawing], [&] { bench.Turn(Row::Drawing, 1); });
    measure("  turned",
      [&]
      {
        const QPoint middle = view->rect().center();
        SendMouse(view, QEvent::MouseButtonPress, middle);
        for (int step = 1; step <= Steps; ++step)
        {
          SendMouse(view, QEvent::MouseMove, middle + QPoint(4 * step, step));
          QApplication::processEvents();
        }
        SendMouse(view, QEvent::MouseButtonRelease, middle + QPoint(4 * Steps, Steps));
      });
    measure("  ten clicks of the wheel",
      [&]
      {
        for (int click = 0; click < Clicks; ++click)
        {
          SendWheel(view);
        }
      });
    measure("  view reset",
      [&]
      {
        bench.Data.ResetView();
        bench.RenderSoon();
      });
    if (!bench.Data.HasNodes())
    {
      continue;
    }
    const std::size_t presets = AllSettings()[Row::Preset].Words.size();
    for (std::size_t preset = 0; preset < presets; ++preset)
    {
      measure("  another preset", [&] { bench.Turn(Row::Preset, 1); });
    }
    measure("  shifted",
      [&]
      {
        bench.SetDragging(true);
        for (int step = 0; step < Steps; ++step)
        {
          bench.SetShare(AllSettings()[Row::Shift], 0.5 + 0.01 * step);
          QApplication::processEvents();
        }
        bench.SetDragging(false);
      });
    measure("  clipped", [&] { bench.Turn(Row::Clipping, 1); });
    measure("  whole", [&] { bench.Turn(Row::Clipping, 1); });
  }
}
