// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/DragMeasurement.h"

#include "Window/MainWindow.h"

#include <vtkCamera.h>
#include <vtkImageActor.h>
#include <vtkImageMapper3D.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>

#include <QApplication>
#include <QMouseEvent>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <vector>

namespace
{

// Parts of the range of values: the drag begins and ends where volumes have surfaces.
constexpr double From = 0.2;
constexpr double To = 0.8;

double Median(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times.empty() ? 0.0 : times[times.size() / 2];
}

// Milliseconds until it is seen.
double TimeOf(QVTKOpenGLNativeWidget* view, const std::function<void()>& action)
{
  bool isShown = false;
  const auto connection =
    QObject::connect(view, &QOpenGLWidget::frameSwapped, view, [&isShown] { isShown = true; });
  const double begin = vtkTimerLog::GetUniversalTime();
  action();
  while (!isShown)
  {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  QObject::disconnect(connection);
  return 1000.0 * (vtkTimerLog::GetUniversalTime() - begin);
}

void SendMouse(HistogramPanel* histogram, QEvent::Type type, double share)
{
  const QPoint place = histogram->PlaceOf(share);
  QMouseEvent event(type, place, histogram->mapToGlobal(place), Qt::LeftButton,
    type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(histogram, &event);
}

double MedianOfPictures(MainWindow& window, const std::vector<vtkSmartPointer<vtkImageData>>& two,
  vtkRenderer* before, int count)
{
  vtkRenderWindow* shown = window.View()->renderWindow();
  vtkNew<vtkImageActor> actor;
  vtkNew<vtkRenderer> renderer;
  shown->RemoveRenderer(before);
  shown->AddRenderer(renderer);
  actor->GetMapper()->SetInputData(two[0]);
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->ResetCamera();
  renderer->GetActiveCamera()->SetParallelScale(0.5 * two[0]->GetDimensions()[1]);
  std::vector<double> times;
  for (int i = 0; i <= count; ++i)
  {
    const double ms = TimeOf(window.View(),
      [&]
      {
        two[static_cast<std::size_t>(i % 2)]->Modified();
        actor->GetMapper()->SetInputData(two[static_cast<std::size_t>(i % 2)]);
        shown->Render();
      });
    times.insert(times.end(), i > 0 ? 1 : 0, ms); // the first makes what is kept
  }
  shown->RemoveRenderer(renderer);
  shown->AddRenderer(before);
  return Median(times);
}

}

void MeasureDrag(MainWindow& window, Workbench& bench, int steps)
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures = { bench.Data.View.LastFrame() };
  std::map<std::string, int> routes;
  std::vector<double> times;
  SendMouse(window.Histogram(), QEvent::MouseButtonPress, From);
  while (bench.IsBusy())
  {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  // More than one a step: parts of the window were drawn apart.
  int shown = 0;
  const auto counting = QObject::connect(
    window.View(), &QOpenGLWidget::frameSwapped, window.View(), [&shown] { ++shown; });
  for (int step = 1; step <= steps; ++step)
  {
    const double share = From + (To - From) * step / steps;
    times.push_back(
      TimeOf(window.View(), [&] { SendMouse(window.Histogram(), QEvent::MouseMove, share); }));
    ++routes[bench.Data.View.Facts().Route];
  }
  QObject::disconnect(counting);
  SendMouse(window.Histogram(), QEvent::MouseButtonRelease, To);
  pictures.push_back(bench.Data.View.LastFrame());
  const double drag = Median(times);
  const double picture = MedianOfPictures(window, pictures, bench.Data.View.Renderer, steps);
  const int* size = pictures[0]->GetDimensions();
  std::printf(
    "Drag of %d steps in %d x %d pixels: median %.2f ms a frame (", steps, size[0], size[1], drag);
  const char* separator = "";
  for (const auto& [route, count] : routes)
  {
    std::printf("%s%s %d", separator, route.c_str(), count);
    separator = ", ";
  }
  std::printf("), the window drawn %d times\nAny picture of that size in the same widget: median "
              "%.2f ms\nRatio: %.2f\n",
    shown, picture, drag / picture);
}
