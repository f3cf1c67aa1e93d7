// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapWindow.h"

#include "Measuring.h"

#include <vtkCamera.h>
#include <vtkImageActor.h>
#include <vtkImageMapper3D.h>
#include <vtkRenderWindow.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace IsomapWindow
{
namespace
{

constexpr double Step = 0.0002; ///< from one isovalue to the next, of the range of values
constexpr int StepsOneWay = 10; ///< so that they stay in the first band

/// A window in which one renderer is drawn.
struct View
{
  View(vtkRenderer* renderer, int size)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(renderer);
  }

  double Draw()
  {
    return Measuring::TimeOf(
      [&]
      {
        this->Window->Render();
        this->Window->WaitForCompletion();
      });
  }

  vtkNew<vtkRenderWindow> Window;
};

void MeasureVolume(Stage& stage, int frames, Times& times)
{
  const double isovalue = stage.Isovalue();
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  mapper->SetInputData(stage.Image);
  stage.Volume->SetMapper(mapper);
  stage.Renderer->AddVolume(stage.Volume);
  View view(stage.Renderer, stage.Size);
  view.Draw();
  std::vector<double> lookups, presents, reshades;
  for (int frame = 1; frame <= frames; ++frame)
  {
    const int step = 1 + frame % StepsOneWay;
    stage.SetIsovalue(isovalue + stage.ShareOfRange(Step * step));
    const double time = view.Draw();
    if (std::string(mapper->GetRouteAsString()) == "IsomapLookup")
    {
      lookups.push_back(time);
      presents.push_back(1e3 * mapper->GetPresentTime());
    }
    stage.Volume->GetProperty()->SetDiffuse(0.6 + 0.01 * (frame % StepsOneWay));
    reshades.push_back(view.Draw());
  }
  stage.SetIsovalue(isovalue);
  stage.Renderer->RemoveVolume(stage.Volume);
  stage.Volume->SetMapper(nullptr);
  times.Lookup = Measuring::Median(lookups);
  times.Present = Measuring::Median(presents);
  times.Reshade = Measuring::Median(reshades);
}

/// Two pictures in turn, pixel for pixel, so that each has to be sent.
double PictureTime(Stage& stage, int frames)
{
  std::array<Drawer, 2> pictures = { Drawer(stage), Drawer(stage) };
  pictures[0].Draw(stage);
  stage.Orbit(2.0);
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
  View view(renderer, stage.Size);
  view.Draw();
  std::vector<double> times;
  for (int frame = 1; frame <= frames; ++frame)
  {
    vtkImageData* picture = pictures[static_cast<std::size_t>(frame % 2)].Color;
    picture->Modified();
    actor->GetMapper()->SetInputData(picture);
    times.push_back(view.Draw());
  }
  return Measuring::Median(times);
}

}

Times Measure(Stage& stage, int frames)
{
  Times times;
  times.Picture = PictureTime(stage, frames);
  MeasureVolume(stage, frames, times);
  return times;
}

}
