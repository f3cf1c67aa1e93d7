// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What structures cost beside reading the samples once.

#include "Measuring.h"
#include "Scenario.h"
#include "StructureTimes.h"

#include <iostream>

namespace
{

using Measuring::Ratio;

constexpr int UsualFrames = 9;
constexpr double MiB = 1024.0 * 1024.0;

void AddTo(JsonWriter& json, const StructureTimes::Times& t)
{
  json.Add("volumeBytes", t.VolumeBytes);
  json.Add("readMs", t.Read);
  json.Add("pyramidMs", t.Pyramid);
  json.Add("pyramidByRead", Ratio(t.Pyramid, t.Read));
  json.Add("pyramidBytes", t.PyramidBytes);
  json.Add("activeCellsMs", t.ActiveCells);
  json.Add("activeCellsBytes", t.ActiveBytes);
  json.Add("isomapBuildMs", t.Isomap);
  json.Add("isomapBytes", t.IsomapBytes);
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Medians in ms, memory in MiB; reading: a parallel sum over all samples\n\n";
  const MarkdownTable table({ "volume", "isovalue", "memory", "reading", "GB/s", "value ranges",
    "/ reading", "memory", "active cells", "memory", "isomap", "memory" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const StructureTimes::Times t = StructureTimes::Measure(stage, frames);
    table.Row({ volume.Name, Plain(volume.Isovalue), Fixed(t.VolumeBytes / MiB, 1),
      Fixed(t.Read, 2), Fixed(1e-6 * Ratio(t.VolumeBytes, t.Read), 1), Fixed(t.Pyramid, 2),
      Fixed(Ratio(t.Pyramid, t.Read), 2), Fixed(t.PyramidBytes / MiB, 2), Fixed(t.ActiveCells, 2),
      Fixed(t.ActiveBytes / MiB, 2), Fixed(t.Isomap, 1), Fixed(t.IsomapBytes / MiB, 1) });
    AddTo(json, t);
  };
  return ReportVolumes(settings, ManyVolumes(), json, measure);
}

}

Scenario Scenarios::Structures()
{
  return { "structures", "value ranges, active cells and isomap beside reading the samples", Run,
    false };
}
