// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GrowthPlots.h"

#include "Measuring.h"
#include "Plots.h"
#include "Report.h"
#include "TypicalFrames.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace GrowthPlots
{
namespace
{

/// A kind of frame that has lines in the plots.
struct Kind
{
  const char* Name;
  double TypicalFrames::Times::*Time;
};
constexpr std::array<Kind, 2> Kinds = { { { "cold", &TypicalFrames::Times::Cold },
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

void TimesByVoxels(const std::vector<GrowthSteps::Step>& steps, const std::string& path)
{
  Plots::Chart chart;
  chart.Title = "Times with more and more samples of the same object";
  chart.XTitle = "Samples";
  chart.YTitle = "Milliseconds a frame";
  int largest = 0;
  for (const GrowthSteps::Step& step : steps)
  {
    largest = std::max(largest, step.SamplesASide);
  }
  for (int n = GrowthSteps::Smallest; n <= largest; n *= 2)
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
  Plots::Write(chart, path);
}

void SpeedUpByThreads(const std::vector<VolumeThreads>& volumes, const std::string& path)
{
  Plots::Chart chart;
  chart.Title = "Speed-up by threads";
  chart.XTitle = "Threads";
  chart.YTitle = "Time of one thread by that of so many";
  for (const auto& [name, all] : volumes)
  {
    const int color = static_cast<int>(chart.Series.size() / 2);
    for (std::size_t kind = 0; kind < Kinds.size(); ++kind)
    {
      chart.Series.push_back(LineOf(name, kind, all));
      chart.Series.back().Color = color;
      chart.Series.back().IsDashed = kind != 0;
    }
  }
  if (chart.Series.empty() || chart.Series.front().X.size() < 2)
  {
    return;
  }
  for (const double threads : chart.Series.front().X)
  {
    chart.XTicks.emplace_back(threads, Plain(threads));
  }
  Plots::Write(chart, path);
}

}
