// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What vectors gain over the reference without them.

#include "Checks/VectorTarget.h"
#include "Scenario.h"
#include "TypicalFrames.h"

#include <algorithm>
#include <iostream>

namespace
{

constexpr int UsualFrames = 20;

/// One kind of vectors.
struct Times
{
  std::string Target;
  TypicalFrames::Times Frames;
};

/// All kinds that the machine has, the reference first.
std::vector<Times> Measure(Stage& stage, int frames)
{
  std::vector<std::int64_t> targets = VectorTarget::All();
  std::reverse(targets.begin(), targets.end());
  std::vector<Times> times;
  for (const std::int64_t target : targets)
  {
    const VectorTarget chosen(target);
    times.push_back({ hwy::TargetName(target), TypicalFrames::Measure(stage, frames) });
  }
  return times;
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Medians in ms, and how many times as long the reference takes\n\n";
  const MarkdownTable table = TypicalFrames::BeginComparison({ "volume", "isovalue", "vectors" });
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    const std::vector<Times> all = Measure(stage, frames);
    json.OpenList("vectors");
    for (const Times& t : all)
    {
      TypicalFrames::PrintComparison(
        table, { volume.Name, Plain(volume.Isovalue), t.Target }, all.front().Frames, t.Frames);
      json.OpenObject();
      json.Add("vectors", t.Target);
      TypicalFrames::AddTo(json, t.Frames);
      json.Close();
    }
    json.Close();
  };
  return ReportVolumes(settings, FewVolumes(), json, measure);
}

}

Scenario Scenarios::Vectors()
{
  return { "vectors", "the same frames with each kind of vectors, beside none (SIMD)", Run };
}
