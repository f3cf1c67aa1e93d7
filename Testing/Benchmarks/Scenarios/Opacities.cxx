// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What a new opacity costs: a slider goes down and up again, twice.

#include "Measuring.h"
#include "Scenario.h"

#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <iostream>
#include <string>
#include <vector>

namespace
{

using Measuring::Median;
using Measuring::Ratio;

constexpr double High = 0.9, Low = 0.2;
constexpr int UsualSteps = 20; ///< down and up

void SetOpacity(Stage& stage, double opacity)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(stage.Isovalue(), opacity);
  stage.Volume->GetProperty()->SetScalarOpacity(function);
}

/// The opacities of a slider that goes down and up again.
std::vector<double> SliderOf(int steps)
{
  std::vector<double> opacities;
  for (int i = 1; i <= steps; ++i)
  {
    const double way = 2.0 * i / steps;
    opacities.push_back(High - (High - Low) * (way < 1.0 ? way : 2.0 - way));
  }
  return opacities;
}

/// Frames of a slider, in milliseconds.
struct Slide
{
  std::vector<double> New;            ///< a new opacity
  std::vector<double> Traced;         ///< those of them for which rays were traced
  std::vector<double> Shaded;         ///< the same opacities in another light
  std::vector<double> Ratios;         ///< New / Shaded, step by step
  std::vector<double> RatiosOfTraced; ///< the same for Traced
  double RaysTraced = 0.0;
};

Slide Measure(Stage& stage, Drawer& drawer, int steps)
{
  Slide slide;
  int light = 0;
  for (const double opacity : SliderOf(steps))
  {
    SetOpacity(stage, opacity);
    const double time = drawer.Draw(stage);
    const auto rays = static_cast<double>(drawer.Mapper->GetStatistics()->GetNumberOfTracedRays());
    stage.Volume->GetProperty()->SetDiffuse(0.6 + 0.01 * (++light % 2));
    slide.New.push_back(time);
    slide.Shaded.push_back(drawer.Draw(stage));
    slide.Ratios.push_back(Ratio(time, slide.Shaded.back()));
    if (rays > 0.0)
    {
      slide.Traced.push_back(time);
      slide.RatiosOfTraced.push_back(slide.Ratios.back());
      slide.RaysTraced += rays;
    }
  }
  return slide;
}

/// The same opacities, each by a frame that re-uses nothing.
double MeasureCold(Stage& stage, Drawer& drawer, int steps)
{
  drawer.Mapper->ReuseFramesOff();
  drawer.Mapper->IsomapOff();
  std::vector<double> cold;
  for (const double opacity : SliderOf(steps))
  {
    SetOpacity(stage, opacity);
    cold.push_back(drawer.Draw(stage));
  }
  return Median(cold);
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const int steps = settings.FramesOr(UsualSteps);
  std::cout << "Medians in ms of a slider from " << High << " to " << Low << " and back in "
            << steps << " steps. Traced: the steps for which rays had to go on\n\n";
  const MarkdownTable table({ "volume", "isovalue", "cold", "new opacity", "Reshade",
    "new / Reshade", "traced steps", "ms of these", "/ Reshade", "again", "/ Reshade" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    Drawer drawer(stage);
    SetOpacity(stage, High);
    drawer.Draw(stage);
    const Slide first = Measure(stage, drawer, steps);
    const Slide again = Measure(stage, drawer, steps);
    const double cold = MeasureCold(stage, drawer, steps);
    stage.Volume->GetProperty()->SetScalarOpacity(static_cast<vtkPiecewiseFunction*>(nullptr));
    table.Row({ volume.Name, Plain(volume.Isovalue), Fixed(cold, 1), Fixed(Median(first.New), 1),
      Fixed(Median(first.Shaded), 1), Fixed(Median(first.Ratios), 2),
      std::to_string(first.Traced.size()), Fixed(Median(first.Traced), 1),
      Fixed(Median(first.RatiosOfTraced), 2), Fixed(Median(again.New), 1),
      Fixed(Median(again.Ratios), 2) });
    json.Add("coldMs", cold);
    json.Add("newOpacityMs", Median(first.New));
    json.Add("reshadeMs", Median(first.Shaded));
    json.Add("tracedSteps", static_cast<double>(first.Traced.size()));
    json.Add("tracedMs", Median(first.Traced));
    json.Add("tracedRays", first.RaysTraced);
    json.Add("againMs", Median(again.New));
    json.Add("againRays", again.RaysTraced);
  };
  return ReportVolumes(settings, FewVolumes(), json, measure);
}

}

Scenario Scenarios::Opacities()
{
  return { "opacities", "what a new opacity costs, beside new light", Run };
}
