// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WindowFrames.h"

#include "Measuring.h"
#include "OffScreenWindow.h"

#include <vtkCamera.h>
#include <vtkImageActor.h>
#include <vtkImageMapper3D.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <cstddef>
#include <functional>

namespace WindowFrames
{
namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

constexpr double Degrees = 2.0; ///< of the orbit, a frame
constexpr double Step = 0.0002; ///< from one isovalue to the next, of the range of values
constexpr int StepsOneWay = 10; ///< so that they stay in the first band

/// How a route is provoked.
struct Change
{
  std::string Route;
  bool HasImageCache;
  std::function<void(Stage&, int frame)> Make;
};

/// In an order in which each begins with an exact picture, and that of the first isovalue.
std::vector<Change> AllChanges(double isovalue)
{
  const auto orbit = [](Stage& stage, int) { stage.Orbit(Degrees); };
  const auto raise = [isovalue](Stage& stage, int frame)
  { stage.SetIsovalue(isovalue + stage.ShareOfRange(Step * (1 + frame % StepsOneWay))); };
  const auto light = [](Stage& stage, int frame)
  { stage.Volume->GetProperty()->SetDiffuse(0.6 + 0.01 * (frame % StepsOneWay)); };
  return { { "ImageCache", true, orbit }, { "Cold", false, orbit },
    { "IsomapLookup", false, raise }, { "Reshade", false, light },
    { "Redisplay", false, [](Stage&, int) {} } };
}

/// The same frames by a mapper without a window and by one with it, in turn.
RouteTimes MeasureRoute(Stage& stage, const Change& change, int frames, Drawer& drawer,
  Mapper* mapper, OffScreenWindow& window)
{
  for (auto* each : { drawer.Mapper.Get(), mapper })
  {
    each->SetReuseFrames(change.HasImageCache);
    each->SetReuseAccuracyToPaper(); // else nearly all views are cold
  }
  std::vector<double> images, windows, presents;
  for (int frame = 0; frame < frames; ++frame)
  {
    change.Make(stage, frame);
    const double image = drawer.Draw(stage);
    const double drawn = window.Draw();
    if (drawer.Route() == change.Route)
    {
      images.push_back(image);
    }
    if (mapper->GetStatistics()->GetRouteAsString() == change.Route)
    {
      windows.push_back(drawn);
      presents.push_back(1e3 * mapper->GetStatistics()->GetPresentTime());
    }
  }
  return { change.Route, Measuring::Median(images), Measuring::Median(windows),
    Measuring::Median(presents) };
}

std::vector<RouteTimes> MeasureRoutes(Stage& stage, int frames)
{
  const double isovalue = stage.Isovalue();
  Drawer drawer(stage);
  vtkNew<Mapper> mapper;
  mapper->SetInputData(stage.Image);
  stage.Volume->SetMapper(mapper);
  stage.Renderer->AddVolume(stage.Volume);
  OffScreenWindow window(stage.Renderer, stage.Size);
  drawer.Draw(stage);
  window.Draw();
  std::vector<RouteTimes> routes;
  for (const Change& change : AllChanges(isovalue))
  {
    routes.push_back(MeasureRoute(stage, change, frames, drawer, mapper, window));
  }
  stage.SetIsovalue(isovalue);
  stage.ResetView();
  stage.Renderer->RemoveVolume(stage.Volume);
  stage.Volume->SetMapper(nullptr);
  return routes;
}

/// Two pictures in turn, pixel for pixel, so that each has to be sent.
double PictureTime(Stage& stage, int frames)
{
  std::array<Drawer, 2> pictures = { Drawer(stage), Drawer(stage) };
  pictures[0].Draw(stage);
  stage.Orbit(Degrees);
  pictures[1].Draw(stage);
  stage.ResetView();

  vtkNew<vtkImageActor> actor;
  actor->GetMapper()->SetInputData(pictures[0].Color);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  renderer->ResetCamera();
  camera->SetParallelScale(0.5 * stage.Size);
  OffScreenWindow window(renderer, stage.Size);
  window.Draw();
  std::vector<double> times;
  for (int frame = 1; frame <= frames; ++frame)
  {
    vtkImageData* picture = pictures[static_cast<std::size_t>(frame % 2)].Color;
    picture->Modified();
    actor->GetMapper()->SetInputData(picture);
    times.push_back(window.Draw());
  }
  return Measuring::Median(times);
}

}

Times Measure(Stage& stage, int frames)
{
  Times times;
  times.Picture = PictureTime(stage, frames);
  times.Routes = MeasureRoutes(stage, frames);
  return times;
}

}
