// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// How pictures that are made from each other part from the cold ones over many frames.

#include "Drift.h"

#include "DriftPlot.h"
#include "Scenario.h"

#include <algorithm>
#include <iostream>

namespace
{

constexpr int QuickFrames = 60;

bool Run(const Settings& settings, JsonWriter& json)
{
  const int usual = settings.IsQuick ? QuickFrames : Drift::LongRun;
  const int frames = std::max(settings.Frames > 0 ? settings.Frames : usual, Drift::Stride);
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const std::vector<Drift::Curve> curves = Drift::Run(stage, frames);
    std::cout << "Percent of the pixels that differ from cold over " << frames << " frames, "
              << volume.Name << ' ' << volume.Isovalue << "\n\n";
    Drift::PrintTable(curves);
    std::cout << '\n';
    Drift::AddTo(json, curves);
    if (!settings.Plots.empty())
    {
      PlotDrift(curves, volume.Name, settings.Size, settings.Plots + "/drift");
    }
  };
  return ReportVolumes(settings, { { "engine.vti", 70 } }, json, measure);
}

}

Scenario Scenarios::Drift()
{
  return { "drift", "errors of the image cache over many frames", Run, false };
}
