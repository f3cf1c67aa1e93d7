// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The mapper beside VTK's other ways to an isosurface, in the same run and view.

#include "Display.h"
#include "Measuring.h"
#include "PeerFrames.h"
#include "Scenario.h"

#include <iostream>

namespace
{

constexpr int UsualFrames = 12;

void AddTo(JsonWriter& json, const PeerFrames::Times& times, const PeerFrames::Times& ours)
{
  json.OpenObject();
  json.Add("who", times.Who);
  json.Add("pixels", times.Size);
  json.Add("drawnPercent", times.PercentDrawn);
  json.Add("newViewMs", times.NewView);
  json.Add("newViewByOurs", Measuring::Ratio(times.NewView, ours.NewView));
  json.Add("newIsovalueMs", times.NewIsovalue);
  json.Add("newIsovalueByOurs", Measuring::Ratio(times.NewIsovalue, ours.NewIsovalue));
  json.Close();
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const bool hasWindow = HasDisplayOrTell("Peers that draw in a window are");
  const int frames = settings.FramesOr(UsualFrames);
  std::cout
    << "Medians in ms; new view: ours is a cold frame, polygons are only drawn; new "
       "isovalue: ours is looked up, but for the first; / ours: by the line of ours before\n\n";
  const MarkdownTable table({ "volume", "isovalue", "who", "pixels", "drawn %", "new view",
    "/ ours", "new isovalue", "/ ours" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    json.OpenList("peers");
    PeerFrames::Times ours;
    for (const PeerFrames::Times& t : PeerFrames::Measure(stage, frames, hasWindow))
    {
      ours = t.IsOurs ? t : ours;
      table.Row(
        { volume.Name, Plain(volume.Isovalue), t.Who, Plain(t.Size), Fixed(t.PercentDrawn, 0),
          Fixed(t.NewView, 1), Fixed(Measuring::Ratio(t.NewView, ours.NewView), 2),
          Fixed(t.NewIsovalue, 1), Fixed(Measuring::Ratio(t.NewIsovalue, ours.NewIsovalue), 2) });
      AddTo(json, t, ours);
    }
    json.Close();
  };
  return ReportVolumes(settings, ManyVolumes(), json, measure);
}

}

Scenario Scenarios::Peers()
{
  return { "peers", "polygons and VTK's other volume mappers beside this one", Run };
}
