// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The isovalue is dragged in a still view: each frame by a cold one of the same isovalue.

#include "IsomapDrags.h"
#include "Scenario.h"

#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <vector>

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

/// Least CPU time of a few cold frames of opaque surfaces.
double OpaqueMs(Stage& stage)
{
  constexpr int frames = 4;
  Drawer cold(stage);
  cold.Mapper->ImageCacheOff();
  cold.Mapper->IsomapOff();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < frames; ++i)
  {
    cold.DrawCold(stage);
    least = std::min(least, cold.CpuMs);
  }
  return least;
}

bool RunLayers(const Settings& settings, JsonWriter& json)
{
  constexpr double opacity = 0.4;
  constexpr std::size_t paths = 2; // steps of 0.2 % and of 1 %
  std::cout << "Surfaces of opacity 0.4. CPU time of all threads, by that of a cold frame of the "
               "same isovalue,\nand by that of a cold frame of opaque surfaces at the first "
               "isovalue\n\n";
  const MarkdownTable table({ "volume", "isovalue", "drag", "cold, ms", "opaque cold, ms", "first",
    "mean", "worst", "mean by opaque", "bytes a pixel", "not the cold picture" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    json.OpenList("layerDrags");
    const double opaqueMs = OpaqueMs(stage);
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(stage.Isovalue(), opacity);
    stage.Volume->GetProperty()->SetScalarOpacity(function);
    std::vector<IsomapDrags::Path> all =
      IsomapDrags::AllPaths(stage, settings.Steps > 0 ? settings.Steps : 20);
    all.resize(paths);
    for (const IsomapDrags::Path& path : all)
    {
      const IsomapDrags::Summary d = IsomapDrags::Run(stage, path);
      table.Row({ volume.Name, Plain(volume.Isovalue), d.Path, Fixed(d.ColdMs, 1),
        Fixed(opaqueMs, 1), Fixed(d.First, 2), Fixed(d.Mean, 2), Fixed(d.Worst, 2),
        Fixed(d.Mean * d.ColdMs / opaqueMs, 2), Fixed(d.BytesAPixel, 1), Plain(d.Different) });
      AddTo(json, d);
    }
    json.Close();
  };
  return ReportVolumes(settings,
    { { "spheres256", 100 }, { "marschner-lobb256", 128 }, { "engine.vti", 70 },
      { "brain.vti", 40 } },
    json, measure);
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

Scenario Scenarios::LayerDrags()
{
  return { "layer-drags", "the same of translucent surfaces", RunLayers };
}
