// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What showing costs: frames in a render window beside the same ones without it.

#include "Display.h"
#include "Measuring.h"
#include "Scenario.h"
#include "WindowFrames.h"

#include <iostream>

namespace
{

constexpr int UsualFrames = 20;

void AddTo(JsonWriter& json, const WindowFrames::Times& times)
{
  json.Add("pictureMs", times.Picture);
  json.OpenList("routes");
  for (const WindowFrames::RouteTimes& t : times.Routes)
  {
    json.OpenObject();
    json.Add("route", t.Route);
    json.Add("imageMs", t.Image);
    json.Add("windowMs", t.Window);
    json.Add("presentMs", t.Present);
    json.Close();
  }
  json.Close();
}

bool Run(const Settings& settings, JsonWriter& json)
{
  if (!HasDisplayOrTell("Frames in a window are"))
  {
    return false;
  }
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Medians in ms; window: Render() until all is drawn, showing being the mapper's own "
               "part of it; any picture: a vtkImageActor\n\n";
  const MarkdownTable table({ "volume", "isovalue", "route", "MakeImage", "window", "(showing)",
    "window - MakeImage", "any picture", "window / any picture" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const WindowFrames::Times times = WindowFrames::Measure(stage, frames);
    for (const WindowFrames::RouteTimes& t : times.Routes)
    {
      table.Row({ volume.Name, Plain(volume.Isovalue), t.Route, Fixed(t.Image, 1),
        Fixed(t.Window, 1), Fixed(t.Present, 1), Fixed(t.Window - t.Image, 1),
        Fixed(times.Picture, 1), Fixed(Measuring::Ratio(t.Window, times.Picture), 2) });
    }
    AddTo(json, times);
  };
  return ReportVolumes(settings,
    { { "engine.vti", 70 }, { "engine.vti", 180 }, { "brain.vti", 40 }, { "brain.vti", 90 },
      { "bonsai.vti", 40 }, { "ch2better.nii.gz", 40 }, { "spheres256", 100 },
      { "marschner-lobb256", 128 }, { "marschner-lobb512", 128 } },
    json, measure);
}

}

Scenario Scenarios::Window()
{
  return { "window", "what showing a frame in a render window costs, route by route", Run };
}
