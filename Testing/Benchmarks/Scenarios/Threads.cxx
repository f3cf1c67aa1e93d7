// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What more threads gain.

#include "GrowthPlots.h"
#include "Scenario.h"
#include "ThreadFrames.h"

#include <iostream>

namespace
{

constexpr int UsualFrames = 20;

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Medians in ms, and how many times as long one thread takes\n\n";
  const MarkdownTable table =
    TypicalFrames::BeginComparison({ "volume", "isovalue", "threads", "by" });
  std::vector<GrowthPlots::VolumeThreads> volumes;
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const std::vector<ThreadFrames::Times> all = ThreadFrames::Measure(stage, frames);
    for (const ThreadFrames::Times& t : all)
    {
      TypicalFrames::PrintComparison(table,
        { volume.Name, Plain(volume.Isovalue), Plain(t.Threads), t.Backend }, all.front().Frames,
        t.Frames);
    }
    ThreadFrames::AddTo(json, all);
    volumes.emplace_back(volume.Name, all);
  };
  const bool isMeasured = ReportVolumes(settings, FewVolumes(), json, measure);
  if (!settings.Plots.empty())
  {
    GrowthPlots::SpeedUpByThreads(volumes, settings.Plots + "/threads");
  }
  return isMeasured;
}

}

Scenario Scenarios::Threads()
{
  return { "threads", "the same frames with more and more threads", Run };
}
