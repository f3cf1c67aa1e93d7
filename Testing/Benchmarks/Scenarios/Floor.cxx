// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The least that a picture takes if its hit cells are known, beside a cold frame.

#include "Floor.h"
#include "Measuring.h"
#include "Scenario.h"

#include <iostream>

namespace
{

constexpr int UsualFrames = 25;

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Medians in ms; floor: the hit cells are known, ns of all threads for each hit\n\n";
  const MarkdownTable table({ "volume", "isovalue", "hits %", "floor", "ns", "cold", "in floors" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const Floor::Times floor = Floor::Measure(stage, frames);
    Drawer drawer(stage);
    std::vector<double> colds;
    for (int frame = 0; frame < frames; ++frame)
    {
      colds.push_back(drawer.DrawCold(stage));
    }
    const double cold = Measuring::Median(colds);
    const double inFloors = Measuring::Ratio(cold, floor.Milliseconds);
    table.Row({ volume.Name, Plain(volume.Isovalue), Fixed(PercentHit(drawer), 1),
      Fixed(floor.Milliseconds, 2), Fixed(floor.PerHit, 1), Fixed(cold, 2), Fixed(inFloors, 1) });
    json.Add("hits", floor.Hits);
    json.Add("floorMs", floor.Milliseconds);
    json.Add("floorNsPerHit", floor.PerHit);
    json.Add("coldMs", cold);
    json.Add("coldInFloors", inFloors);
  };
  return ReportVolumes(settings, FewVolumes(), json, measure);
}

}

Scenario Scenarios::Floor()
{
  return { "floor", "the least that a picture takes if its hit cells are known", Run };
}
