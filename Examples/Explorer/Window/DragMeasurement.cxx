// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/DragMeasurement.h"

#include "Drawing/TexturedRectangle.h"
#include "Window/ExplorerWindow.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkImageMapper3D.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTimerLog.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
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

// Milliseconds until all is drawn.
double TimeOf(vtkRenderWindow* window, const std::function<void()>& action)
{
  const double begin = vtkTimerLog::GetUniversalTime();
  action();
  window->WaitForCompletion();
  return 1000.0 * (vtkTimerLog::GetUniversalTime() - begin);
}

void SendMouse(ExplorerWindow& window, unsigned long event, double share)
{
  const Rect& panel = window.Panels().Isovalue.Placed();
  const int x = panel.X + static_cast<int>(share * panel.Width);
  const int y = panel.Y + panel.Height / 2;
  window.Interactor()->SetEventInformationFlipY(x, y);
  window.Interactor()->InvokeEvent(event);
}

vtkSmartPointer<vtkImageData> PictureOf(vtkRenderWindow* window)
{
  constexpr int backBuffer = 0;
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, backBuffer, pixels);
  pixels->FillComponent(3, 255);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(pixels);
  return image;
}

std::vector<double> DragTimes(ExplorerWindow& window, int steps, std::map<std::string, int>& routes)
{
  std::vector<double> times;
  SendMouse(window, vtkCommand::LeftButtonPressEvent, From);
  for (int step = 1; step <= steps; ++step)
  {
    const double share = From + (To - From) * step / steps;
    times.push_back(
      TimeOf(window.Window(), [&] { SendMouse(window, vtkCommand::MouseMoveEvent, share); }));
    ++routes[window.Opened().View.Facts().Route];
  }
  SendMouse(window, vtkCommand::LeftButtonReleaseEvent, To);
  return times;
}

using Pictures = std::array<vtkSmartPointer<vtkImageData>, 2>;

// Nothing but the picture is in the window, and each time it is another one than before.
class PlainWindow
{
public:
  explicit PlainWindow(vtkRenderWindow* like)
    : Size(like->GetSize())
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(this->Size[0], this->Size[1]);
    this->Window->AddRenderer(this->Renderer);
  }

  // As VTK shows pictures.
  double ByImageActor(const Pictures& pictures, int count)
  {
    vtkNew<vtkImageActor> actor;
    actor->GetMapper()->SetInputData(pictures[0]);
    this->Renderer->AddActor(actor);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    this->Renderer->ResetCamera();
    camera->SetParallelScale(0.5 * this->Size[1]);
    const double ms = this->MedianTime(count,
      [&](std::size_t which)
      {
        pictures[which]->Modified();
        actor->GetMapper()->SetInputData(pictures[which]);
      });
    this->Renderer->RemoveActor(actor);
    return ms;
  }

  // The least that OpenGL has to do, with no regard to depth.
  double ByRectangle(const Pictures& pictures, int count)
  {
    TexturedRectangle rectangle(this->Renderer);
    rectangle.Place({ 0, 0, this->Size[0], this->Size[1] }, this->Size[1]);
    rectangle.SetVisible(true);
    return this->MedianTime(count, [&](std::size_t which) { rectangle.SetImage(pictures[which]); });
  }

private:
  double MedianTime(int count, const std::function<void(std::size_t which)>& show)
  {
    std::vector<double> times;
    for (int i = 0; i <= count; ++i)
    {
      const double ms = TimeOf(this->Window,
        [&]
        {
          show(static_cast<std::size_t>(i % 2));
          this->Window->Render();
        });
      if (i > 0) // the first makes what is kept
      {
        times.push_back(ms);
      }
    }
    return Median(times);
  }

  const int* Size;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

}

void MeasureDrag(ExplorerWindow& window, int steps)
{
  window.Render();
  Pictures pictures = { PictureOf(window.Window()), nullptr };
  std::map<std::string, int> routes;
  const double drag = Median(DragTimes(window, steps, routes));
  pictures[1] = PictureOf(window.Window());
  PlainWindow plain(window.Window());
  const double picture = plain.ByImageActor(pictures, steps);
  const double rectangle = plain.ByRectangle(pictures, steps);

  const int* size = window.Window()->GetSize();
  std::printf(
    "Drag of %d steps in %d x %d pixels: median %.2f ms a frame (", steps, size[0], size[1], drag);
  const char* separator = "";
  for (const auto& [route, count] : routes)
  {
    std::printf("%s%s %d", separator, route.c_str(), count);
    separator = ", ";
  }
  std::printf(")\nAny picture of that size: median %.2f ms by a vtkImageActor, %.2f ms as a bare "
              "textured rectangle\nRatio: %.2f to the one, %.2f to the other\n",
    picture, rectangle, drag / picture, drag / rectangle);
}
