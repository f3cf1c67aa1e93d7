// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What features cost: frames with each of them switched on beside those without.

#include "FeatureFrames.h"
#include "Measuring.h"
#include "Scenario.h"

#include <iostream>

namespace
{

constexpr int UsualFrames = 12;

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Medians in ms; cold: moved by 2 degrees; shaded: only the light changed\n\n";
  const MarkdownTable table(
    { "volume", "isovalue", "feature", "cold", "shaded", "cold / cold without" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const std::vector<FeatureFrames::Times> all = FeatureFrames::Measure(stage, frames);
    json.OpenList("features");
    for (const FeatureFrames::Times& times : all)
    {
      table.Row({ volume.Name, Plain(volume.Isovalue), times.Feature, Fixed(times.Cold, 1),
        Fixed(times.Shaded, 1), Fixed(Measuring::Ratio(times.Cold, all.front().Cold), 2) });
      json.OpenObject();
      json.Add("feature", times.Feature);
      json.Add("coldMs", times.Cold);
      json.Add("shadedMs", times.Shaded);
      json.Close();
    }
    json.Close();
  };
  return ReportVolumes(settings, FewVolumes(), json, measure);
}

}

Scenario Scenarios::Features()
{
  return { "features", "what clipping, translucent surfaces, hidden cells and others cost", Run };
}
