// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Every route on many volumes.

#include "Measuring.h"
#include "Scenario.h"

#include <vtkVolumeProperty.h>

#include <iostream>
#include <string>
#include <vector>

namespace
{

using Measuring::Median;

constexpr int UsualFrames = 12;
constexpr int PlainFrames = 3;

/// Medians in milliseconds.
struct Times
{
  double First = 0.0;          ///< first frame, structures and all
  double Cold = 0.0;           ///< orbit
  double Trace = 0.0;          ///< of the cold frame
  double Shade = 0.0;          ///< of the cold frame
  double FirstThreshold = 0.0; ///< the first new isovalue in a view
  double Threshold = 0.0;      ///< those after it
  double Reshade = 0.0;
  double Redisplay = 0.0;
  double PlainCold = 0.0; ///< without space leaping
  double PercentHit = 0.0;
};

/// Every view is a new one, made with no help from the last.
void TimeColdFrames(Stage& stage, Drawer& drawer, int frames, Times& times)
{
  times.First = drawer.Draw(stage);
  drawer.Mapper->ImageCacheOff();
  std::vector<double> cold, trace, shade;
  for (int i = 0; i < frames; ++i)
  {
    stage.Orbit(2.0);
    cold.push_back(drawer.Draw(stage));
    trace.push_back(1e3 * drawer.Mapper->GetTraceTime());
    shade.push_back(1e3 * drawer.Mapper->GetShadeTime());
  }
  drawer.Mapper->ImageCacheOn();
  times.Cold = Median(cold);
  times.Trace = Median(trace);
  times.Shade = Median(shade);
}

/// The view stays; first only the light changes, then the isovalue.
void TimeStillFrames(Stage& stage, Drawer& drawer, int frames, Times& times)
{
  std::vector<double> threshold, reshade, redisplay;
  for (int i = 0; i < frames; ++i)
  {
    redisplay.push_back(drawer.Draw(stage));
    stage.Volume->GetProperty()->SetDiffuse(0.6 + 0.01 * i);
    reshade.push_back(drawer.Draw(stage));
  }
  const double isovalue = stage.Isovalue();
  for (int i = 0; i < frames; ++i)
  {
    stage.SetIsovalue(isovalue + stage.SweepStep(i));
    threshold.push_back(drawer.Draw(stage));
  }
  times.FirstThreshold = threshold.front();
  threshold.erase(threshold.begin());
  times.Threshold = Median(threshold);
  times.Reshade = Median(reshade);
  times.Redisplay = Median(redisplay);
}

void TimePlainFrames(Stage& stage, Drawer& drawer, Times& times)
{
  drawer.Mapper->SpaceLeapingOff();
  drawer.Mapper->ImageCacheOff();
  std::vector<double> plain;
  for (int i = 0; i < PlainFrames; ++i)
  {
    stage.Orbit(2.0);
    plain.push_back(drawer.Draw(stage));
  }
  times.PlainCold = Median(plain);
}

Times Measure(Stage& stage, int frames)
{
  Times times;
  Drawer drawer(stage);
  TimeColdFrames(stage, drawer, frames, times);
  TimeStillFrames(stage, drawer, frames, times);
  TimePlainFrames(stage, drawer, times);
  times.PercentHit = PercentHit(drawer);
  return times;
}

void AddTo(JsonWriter& json, const Times& t)
{
  json.Add("hitPercent", t.PercentHit);
  json.Add("firstMs", t.First);
  json.Add("coldMs", t.Cold);
  json.Add("traceMs", t.Trace);
  json.Add("shadeMs", t.Shade);
  json.Add("firstThresholdMs", t.FirstThreshold);
  json.Add("thresholdMs", t.Threshold);
  json.Add("reshadeMs", t.Reshade);
  json.Add("redisplayMs", t.Redisplay);
  json.Add("plainColdMs", t.PlainCold);
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Medians in ms\n\n";
  const MarkdownTable table({ "volume", "isovalue", "hit", "first", "cold", "(trace + shade)",
    "first new isovalue", "later ones", "Reshade", "Redisplay", "plain cold" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const Times t = Measure(stage, frames);
    table.Row(
      { volume.Name, Plain(volume.Isovalue), Fixed(t.PercentHit, 0) + " %", Fixed(t.First, 0),
        Fixed(t.Cold, 1), Fixed(t.Trace, 1) + " + " + Fixed(t.Shade, 1), Fixed(t.FirstThreshold, 1),
        Fixed(t.Threshold, 1), Fixed(t.Reshade, 1), Fixed(t.Redisplay, 1), Fixed(t.PlainCold, 0) });
    AddTo(json, t);
  };
  return ReportVolumes(settings, ManyVolumes(), json, measure);
}

}

Scenario Scenarios::Routes()
{
  return { "routes", "every route: what each kind of frame costs", Run };
}
