// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What a new isovalue of one of two translucent surfaces costs: each is dragged in small steps.

#include "Measuring.h"
#include "Scenario.h"

#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <iostream>
#include <string>
#include <vector>

namespace
{

using Measuring::Median;
using Measuring::Ratio;

constexpr double Opacity = 0.4;
constexpr double Apart = 0.27; ///< of the range of values; of a head: skin and bone
constexpr int UsualSteps = 10;

void Show(Stage& stage, const std::vector<double>& isovalues)
{
  vtkContourValues* list = stage.Volume->GetProperty()->GetIsoSurfaceValues();
  list->SetNumberOfContours(static_cast<int>(isovalues.size()));
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    list->SetValue(static_cast<int>(i), isovalues[i]);
  }
}

/// Frames of a drag, in milliseconds of CPU time, step by step.
struct Drag
{
  std::vector<double> Dragged; ///< by what is known of the other surface
  std::vector<double> Shaded;  ///< the same in another light
  std::vector<double> Cold;    ///< both, by a frame that knows nothing
  std::vector<double> Alone;   ///< the dragged surface alone, by such a frame
  std::string Route;           ///< of the last step
};

/// Drag one of the isovalues.
Drag Measure(Stage& stage, std::vector<double> isovalues, std::size_t which, int steps)
{
  Drag drag;
  Drawer drawer(stage), cold(stage);
  drawer.Mapper->IsomapOff();
  cold.Mapper->ImageCacheOff();
  cold.Mapper->IsomapOff();
  Show(stage, isovalues);
  drawer.Draw(stage);
  const auto cpuOf = [&stage](Drawer& of, std::vector<double>& times)
  {
    of.Draw(stage);
    times.push_back(of.CpuMs);
  };
  const auto cpuOfCold = [&](std::vector<double>& times)
  {
    cold.DrawCold(stage);
    times.push_back(cold.CpuMs);
  };
  for (int step = 0; step < steps; ++step)
  {
    isovalues[which] += stage.ShareOfRange(0.002);
    Show(stage, isovalues);
    cpuOf(drawer, drag.Dragged);
    drag.Route = drawer.Route();
    cpuOfCold(drag.Cold);
    stage.Volume->GetProperty()->SetDiffuse(0.6 + 0.01 * (step % 2));
    cpuOf(drawer, drag.Shaded);
    Show(stage, { isovalues[which] });
    cpuOfCold(drag.Alone);
  }
  return drag;
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const int steps = settings.FramesOr(UsualSteps);
  std::cout << "Medians of CPU time in ms: one of two isovalues is dragged, both at opacity "
            << Opacity << ", in " << steps << " steps of 0.2 % of the range\n\n";
  const MarkdownTable table({ "volume", "isovalues", "dragged", "cold, both", "a step", "/ cold",
    "cold, the dragged alone", "Reshade", "route" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const double low = volume.Isovalue, high = low + stage.ShareOfRange(Apart);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(low, Opacity);
    stage.Volume->GetProperty()->SetScalarOpacity(opacity);
    for (const std::size_t which : { std::size_t(0), std::size_t(1) })
    {
      const Drag drag = Measure(stage, { low, high }, which, steps);
      const double ratio = Ratio(Median(drag.Dragged), Median(drag.Cold));
      const std::string name = which == 0 ? "lower" : "upper";
      table.Row({ volume.Name, Plain(low) + ", " + Plain(high), name, Fixed(Median(drag.Cold), 1),
        Fixed(Median(drag.Dragged), 1), Fixed(ratio, 2), Fixed(Median(drag.Alone), 1),
        Fixed(Median(drag.Shaded), 1), drag.Route });
      json.Add(name + "ColdMs", Median(drag.Cold));
      json.Add(name + "StepMs", Median(drag.Dragged));
      json.Add(name + "AloneMs", Median(drag.Alone));
      json.Add(name + "ReshadeMs", Median(drag.Shaded));
    }
    Show(stage, { low });
    stage.Volume->GetProperty()->SetScalarOpacity(static_cast<vtkPiecewiseFunction*>(nullptr));
  };
  return ReportVolumes(settings, FewVolumes(), json, measure);
}

}

Scenario Scenarios::Surfaces()
{
  return { "surfaces", "what a new isovalue of one of two translucent surfaces costs", Run };
}
