// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The isovalue is dragged in a still view: each frame by a cold one of the same isovalue.

#include "IsomapDrags.h"
#include "Scenario.h"

#include <iostream>

namespace
{

void AddTo(JsonWriter& json, const IsomapDrags::Summary& drag)
{
  json.OpenObject();
  json.Add("drag", drag.Path);
  json.Add("steps", drag.Steps);
  json.Add("coldCpuMs", drag.ColdMs);
  json.Add("firstByCold", drag.First);
  json.Add("meanByCold", drag.Mean);
  json.Add("percentile95ByCold", drag.NearlyWorst);
  json.Add("worstByCold", drag.Worst);
  json.Add("worstAtIsovalue", drag.WorstAt);
  json.Add("newColdByCold", drag.MeanOfNew);
  json.Add("tracedRaysPercent", drag.PercentTraced);
  json.Add("bytesAPixel", drag.BytesAPixel);
  json.Add("differentPictures", drag.Different);
  json.Close();
}

bool Run(const Settings& settings, JsonWriter& json)
{
  std::cout << "CPU time of all threads, by that of a cold frame of the same isovalue whose "
               "structures are there.\ntraced: rays, by those of the cold frames. without isomap: "
               "cold frames that make\nthe structures of their isovalue. Each drag begins in a "
               "mapper that has drawn three frames\n\n";
  const MarkdownTable table({ "volume", "isovalue", "drag", "cold, ms", "first", "mean", "95 %",
    "worst", "at isovalue", "without isomap", "traced", "bytes a pixel", "not the cold picture" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    json.OpenList("drags");
    for (const IsomapDrags::Path& path : IsomapDrags::AllPaths(stage, settings.Steps))
    {
      const IsomapDrags::Summary d = IsomapDrags::Run(stage, path);
      table.Row({ volume.Name, Plain(volume.Isovalue), d.Path, Fixed(d.ColdMs, 1),
        Fixed(d.First, 2), Fixed(d.Mean, 2), Fixed(d.NearlyWorst, 2), Fixed(d.Worst, 2),
        Plain(d.WorstAt), Fixed(d.MeanOfNew, 2), Fixed(d.PercentTraced, 0) + " %",
        Fixed(d.BytesAPixel, 1), Plain(d.Different) });
      AddTo(json, d);
    }
    json.Close();
  };
  return ReportVolumes(settings,
    { { "spheres256", 100 }, { "marschner-lobb256", 128 }, { "engine.vti", 70 },
      { "brain.vti", 40 }, { "bonsai.vti", 40 }, { "heptane.vti", 60 }, { "noise128", 128 } },
    json, measure);
}

}

Scenario Scenarios::Drags()
{
  return { "drags", "the isovalue dragged in a still view, each frame by a cold one", Run };
}
