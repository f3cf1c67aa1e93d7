// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// How times and memory grow with the data and with the picture.

#include "GrowthPlots.h"
#include "GrowthSteps.h"
#include "Scenario.h"

#include <iostream>

namespace
{

constexpr int UsualFrames = 20;

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  const std::vector<GrowthSteps::Step> voxels =
    GrowthSteps::MeasureVoxels(settings.Size, settings.From, settings.Largest, frames);
  std::cout << "Eight times the samples: medians in ms, and by what they multiply\n\n";
  GrowthSteps::PrintTimes(voxels);
  std::cout << "\nWhat the mapper adds to the memory of the process, beside the volume, in MiB\n\n";
  GrowthSteps::PrintMemory(voxels);
  GrowthSteps::AddTo(json, "voxels", voxels);
  if (!settings.Plots.empty())
  {
    GrowthPlots::TimesByVoxels(voxels, settings.Plots + "/growth");
  }

  const std::vector<GrowthSteps::Step> pixels =
    GrowthSteps::MeasurePixels(settings.Size, settings.From, frames);
  std::cout << "\nFour times the pixels\n\n";
  GrowthSteps::PrintTimes(pixels);
  std::cout << '\n';
  GrowthSteps::PrintMemory(pixels);
  GrowthSteps::AddTo(json, "pixels", pixels);
  return true;
}

}

Scenario Scenarios::Growth()
{
  return { "growth", "times and memory with more and more samples, and more and more pixels", Run };
}
