// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DragMeasurement.h"

#include "Mouse.h"
#include "Window/MainWindow.h"

#include <vtkCamera.h>
#include <vtkImageActor.h>
#include <vtkImageMapper3D.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>

#include <QApplication>
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

constexpr int StepsOfTurn = 10; // of the drag, and of pictures

double Median(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times.empty() ? 0.0 : times[times.size() / 2];
}

// Milliseconds until the frame that an action draws is seen.
double TimeOf(MainWindow& window, Workbench& bench, const std::function<void()>& action)
{
  bool isDrawn = false, isShown = false;
  QObject context;
  QObject::connect(&bench, &Workbench::FrameDrawn, &context, [&] { isDrawn = true; });
  QObject::connect(
    window.View(), &QOpenGLWidget::frameSwapped, &context, [&] { isShown = isDrawn; });
  const double begin = vtkTimerLog::GetUniversalTime();
  action();
  while (!isShown)
  {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return 1000.0 * (vtkTimerLog::GetUniversalTime() - begin);
}

void SendMouse(HistogramPanel* histogram, QEvent::Type type, double share)
{
  SendMouse(histogram, type, histogram->PlaceOf(share));
}

// Shows pictures in the view's widget, in turn.
class PictureShow
{
public:
  PictureShow(MainWindow& window, Workbench& bench, vtkImageData* first)
    : Window(window)
    , Bench(bench)
  {
    this->Renderer->AddActor(this->Actor);
    this->Actor->GetMapper()->SetInputData(first);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->SetParallelScale(0.5 * first->GetDimensions()[1]);
  }

  // Milliseconds of each of so many.
  std::vector<double> Times(const std::vector<vtkSmartPointer<vtkImageData>>& two, int count)
  {
    vtkRenderWindow* window = this->Window.View()->renderWindow();
    vtkRenderer* volume = this->Bench.Data.View.Renderer;
    window->RemoveRenderer(volume);
    window->AddRenderer(this->Renderer);
    std::vector<double> times;
    for (int i = 0; i <= count; ++i)
    {
      const double ms = TimeOf(this->Window, this->Bench,
        [&]
        {
          two[static_cast<std::size_t>(i % 2)]->Modified();
          this->Actor->GetMapper()->SetInputData(two[static_cast<std::size_t>(i % 2)]);
          window->Render();
        });
      times.insert(times.end(), i > 0 ? 1 : 0, ms); // the first makes what is kept
    }
    window->RemoveRenderer(this->Renderer);
    window->AddRenderer(volume);
    return times;
  }

private:
  MainWindow& Window;
  Workbench& Bench;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkImageActor> Actor;
};

}

void MeasureDrag(MainWindow& window, Workbench& bench, int steps)
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures = { bench.Data.View.LastFrame() };
  std::map<std::string, int> routes;
  std::vector<double> times, timesOfPictures;
  SendMouse(window.Histogram(), QEvent::MouseButtonPress, From);
  while (bench.IsBusy())
  {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  pictures.push_back(bench.Data.View.LastFrame());
  PictureShow show(window, bench, pictures[0]);
  int shown = 0; // more than once a step: parts of the window were drawn apart
  for (int step = 1; step <= steps; ++step)
  {
    const double share = From + (To - From) * step / steps;
    const auto counting = QObject::connect(
      window.View(), &QOpenGLWidget::frameSwapped, window.View(), [&shown] { ++shown; });
    times.push_back(
      TimeOf(window, bench, [&] { SendMouse(window.Histogram(), QEvent::MouseMove, share); }));
    QObject::disconnect(counting);
    ++routes[bench.Data.View.Mapper->GetStatistics()->GetRouteAsString()];
    // By turns, so that what else the machine does meets both alike.
    if (step % StepsOfTurn == 0 || step == steps)
    {
      const std::vector<double> more = show.Times(pictures, StepsOfTurn);
      timesOfPictures.insert(timesOfPictures.end(), more.begin(), more.end());
      TimeOf(window, bench, [&] { bench.Render(); }); // the volume is there again
    }
  }
  SendMouse(window.Histogram(), QEvent::MouseButtonRelease, To);
  const double drag = Median(times), picture = Median(timesOfPictures);
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
