// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Every route on many volumes.

#include "Floor.h"
#include "Measuring.h"
#include "Scenario.h"

#include <vtkVolumeProperty.h>

#include <algorithm>
#include <iostream>
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
  double ColdNsPerHit = 0.0;   ///< of all threads, the least of all frames
  double Floor = 0.0;          ///< what the hits take if their cells are known
  double Trace = 0.0;          ///< of the cold frame
  double Shade = 0.0;          ///< of the cold frame
  double FirstThreshold = 0.0; ///< the first new isovalue in a view
  double Threshold = 0.0;      ///< those after it
  double Reshade = 0.0;
  double Redisplay = 0.0;
  double PlainCold = 0.0; ///< without space leaping
  double PercentHit = 0.0;
};

double HitsOf(const Drawer& drawer)
{
  return 0.01 * PercentHit(drawer) * static_cast<double>(drawer.Depth->GetNumberOfPoints());
}

/// Every view is a new one, made with no help from the last.
void TimeColdFrames(Stage& stage, Drawer& drawer, int frames, Times& times)
{
  times.First = drawer.Draw(stage);
  drawer.Mapper->ReuseFramesOff();
  std::vector<double> cold, nanoseconds, trace, shade;
  for (int i = 0; i < frames; ++i)
  {
    stage.Orbit(2.0);
    cold.push_back(drawer.Draw(stage));
    nanoseconds.push_back(1e6 * drawer.CpuMs / std::max(HitsOf(drawer), 1.0));
    trace.push_back(1e3 * drawer.Mapper->GetStatistics()->GetTraceTime());
    shade.push_back(1e3 * drawer.Mapper->GetStatistics()->GetShadeTime());
  }
  drawer.Mapper->ReuseFramesOn();
  times.Cold = Median(cold);
  times.ColdNsPerHit = *std::min_element(nanoseconds.begin(), nanoseconds.end());
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
  drawer.Mapper->ReuseFramesOff();
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
  times.PercentHit = PercentHit(drawer);
  times.Floor = Floor::Measure(stage, frames).Milliseconds;
  TimePlainFrames(stage, drawer, times);
  return times;
}

void AddTo(JsonWriter& json, const Times& t)
{
  json.Add("hitPercent", t.PercentHit);
  json.Add("firstMs", t.First);
  json.Add("coldMs", t.Cold);
  json.Add("coldNsPerHit", t.ColdNsPerHit);
  json.Add("floorMs", t.Floor);
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
  std::cout
    << "Medians in ms; ns: of all threads for each hit; floor: if the cells of hits are known\n\n";
  const MarkdownTable table({ "volume", "isovalue", "hit", "floor", "first", "cold", "ns",
    "cold / floor", "(trace + shade)", "first new isovalue", "/ cold", "later ones", "/ floor",
    "Reshade", "Redisplay", "plain cold" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const Times t = Measure(stage, frames);
    table.Row({ volume.Name, Plain(volume.Isovalue), Fixed(t.PercentHit, 0) + " %",
      Fixed(t.Floor, 2), Fixed(t.First, 0), Fixed(t.Cold, 1), Fixed(t.ColdNsPerHit, 0),
      Fixed(Measuring::Ratio(t.Cold, t.Floor), 1), Fixed(t.Trace, 1) + " + " + Fixed(t.Shade, 1),
      Fixed(t.FirstThreshold, 1), Fixed(Measuring::Ratio(t.FirstThreshold, t.Cold), 2),
      Fixed(t.Threshold, 1), Fixed(Measuring::Ratio(t.Threshold, t.Floor), 1), Fixed(t.Reshade, 1),
      Fixed(t.Redisplay, 1), Fixed(t.PlainCold, 0) });
    AddTo(json, t);
  };
  return ReportVolumes(settings, ManyVolumes(), json, measure);
}

}

Scenario Scenarios::Routes()
{
  return { "routes", "every route: what each kind of frame costs", Run };
}
