// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// New isovalues in a still view beside cold frames, and what maps cost. Drags: Drags.cxx.

#include "IsomapFrames.h"
#include "IsomapMaps.h"
#include "IsomapPlots.h"
#include "IsomapReport.h"
#include "Scenario.h"

#include <iostream>

namespace
{

constexpr int UsualFrames = 40;

IsomapReport::Result Measure(const Volumes::Sample& volume, Stage& stage, int frames)
{
  IsomapReport::Result result;
  result.Volume = volume;
  result.Frames = IsomapFrames::Measure(stage, frames);
  result.Widths = IsomapMaps::MeasureWidths(stage);
  result.Tolerances = IsomapMaps::MeasureTolerances(stage);
  return result;
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::vector<IsomapReport::Result> results;
  if (!ForEachStage(settings,
        { { "engine.vti", 70 }, { "engine.vti", 180 }, { "brain.vti", 40 }, { "brain.vti", 90 },
          { "bonsai.vti", 40 }, { "ch2better.nii.gz", 40 }, { "spheres128", 100 },
          { "spheres256", 100 }, { "spheres512", 100 }, { "marschner-lobb128", 128 },
          { "marschner-lobb256", 128 }, { "marschner-lobb512", 128 } },
        [&](const Volumes::Sample& volume, Stage& stage)
        { results.push_back(Measure(volume, stage, frames)); }))
  {
    return false;
  }
  std::cout << "One frame; medians in ms (plain: without space leaping)\n\n";
  IsomapReport::PrintFrames(results);
  std::cout << "\nA map of the whole range of values; times in ms\n\n";
  IsomapReport::PrintWholeMaps(results);
  std::cout << '\n';
  IsomapReport::PrintWidths(results);
  IsomapReport::PrintTolerances(results);
  IsomapReport::AddTo(json, results);
  if (!settings.Plots.empty())
  {
    IsomapPlots::Write(results, settings.Plots);
  }
  return true;
}

}

Scenario Scenarios::Isomap()
{
  return { "isomap", "a new isovalue in a still view, and what isomaps cost", Run };
}
