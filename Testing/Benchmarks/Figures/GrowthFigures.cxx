// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GrowthFigures.h"

#include "GrowthSteps.h"
#include "Measuring.h"
#include "Plots.h"
#include "Stage.h"
#include "ThreadFrames.h"
#include "TypicalFrames.h"

#include <vtkSMPTools.h>

#include <array>
#include <iostream>
#include <string>
#include <vector>

namespace GrowthFigures
{
namespace
{

/// A kind of frame that has lines in the plots.
struct Kind
{
  const char* Name;
  double TypicalFrames::Times::*Time;
};
constexpr std::array<Kind, 3> Kinds = { { { "cold", &TypicalFrames::Times::Cold },
  { "image cache", &TypicalFrames::Times::Cached },
  { "isovalue looked up", &TypicalFrames::Times::Lookup } } };

/// Times of the kind over doublings of the samples a side.
Plots::Series LineOf(
  const std::string& object, std::size_t kind, const std::vector<GrowthSteps::Step>& steps)
{
  Plots::Series series;
  series.Name = object + ", " + Kinds[kind].Name;
  series.Color = static_cast<int>(kind);
  for (const GrowthSteps::Step& step : steps)
  {
    if (step.Object == object)
    {
      series.X.push_back(static_cast<double>(series.X.size()));
      series.Y.push_back(step.Frames.*Kinds[kind].Time);
    }
  }
  return series;
}

/// Speed-ups of the kind over threads, without the last way if it has no more threads.
Plots::Series LineOf(
  const std::string& volume, std::size_t kind, const std::vector<ThreadFrames::Times>& all)
{
  Plots::Series series;
  series.Name = volume + ", " + Kinds[kind].Name;
  for (const ThreadFrames::Times& times : all)
  {
    if (series.X.empty() || times.Threads > series.X.back())
    {
      const auto time = Kinds[kind].Time;
      series.X.push_back(times.Threads);
      series.Y.push_back(Measuring::Ratio(all.front().Frames.*time, times.Frames.*time));
    }
  }
  return series;
}

}

void TimesByVoxels(const Figures::Settings& settings, JsonWriter& json)
{
  const std::vector<GrowthSteps::Step> steps =
    GrowthSteps::MeasureVoxels(settings.Size, settings.Largest, settings.Frames);
  std::cout << "Growth with the samples: ms of a frame\n\n";
  GrowthSteps::PrintTimes(steps);
  std::cout << '\n';
  GrowthSteps::AddTo(json, "growth", steps);

  Plots::Chart chart;
  chart.Title = "Times with more and more samples of the same object";
  chart.XTitle = "Samples";
  chart.YTitle = "Milliseconds a frame";
  for (int n = GrowthSteps::Smallest; n <= settings.Largest; n *= 2)
  {
    chart.XTicks.emplace_back(static_cast<double>(chart.XTicks.size()), Plain(n) + "^3");
  }
  for (const std::string object : { "spheres", "marschner-lobb" })
  {
    for (std::size_t kind = 0; kind < Kinds.size(); ++kind)
    {
      chart.Series.push_back(LineOf(object, kind, steps));
      chart.Series.back().IsDashed = object != "spheres";
    }
  }
  Plots::Write(chart, settings.Output + "/growth");
}

void SpeedUpByThreads(const Figures::Settings& settings, JsonWriter& json)
{
  if (vtkSMPTools::GetEstimatedNumberOfThreads() < 2)
  {
    return;
  }
  Plots::Chart chart;
  chart.Title = "Speed-up by threads";
  chart.XTitle = "Threads";
  chart.YTitle = "Time of one thread by that of so many";
  std::cout << "Threads: ms of a frame\n\n";
  const MarkdownTable table = TypicalFrames::BeginComparison({ "volume", "threads", "by" });
  json.OpenList("threads");
  for (const Figures::Subject& subject : settings.Subjects)
  {
    Stage stage(subject.Image, subject.Isovalue, settings.Size);
    const std::vector<ThreadFrames::Times> all = ThreadFrames::Measure(stage, settings.Frames);
    for (const ThreadFrames::Times& times : all)
    {
      TypicalFrames::PrintComparison(table, { subject.Name, Plain(times.Threads), times.Backend },
        all.front().Frames, times.Frames);
    }
    json.OpenObject();
    json.Add("volume", subject.Name);
    ThreadFrames::AddTo(json, all);
    json.Close();
    const int color = static_cast<int>(chart.Series.size() / 2);
    constexpr std::array<std::size_t, 2> coldAndLookup = { 0, 2 };
    for (const std::size_t kind : coldAndLookup)
    {
      chart.Series.push_back(LineOf(subject.Name, kind, all));
      chart.Series.back().Color = color;
      chart.Series.back().IsDashed = kind != coldAndLookup.front();
    }
  }
  json.Close();
  std::cout << '\n';
  for (const double threads : chart.Series.front().X)
  {
    chart.XTicks.emplace_back(threads, Plain(threads));
  }
  Plots::Write(chart, settings.Output + "/threads");
}

}
