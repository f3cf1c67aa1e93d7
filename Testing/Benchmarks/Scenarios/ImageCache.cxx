// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Frames of a moving camera, cold and from the image cache at each accuracy, and how far they
// differ.

#include "CacheFrames.h"
#include "CacheReport.h"
#include "Scenario.h"

#include <algorithm>
#include <iostream>

namespace
{

constexpr int UsualFrames = 60;
/// The plain ray caster is slow: it gets fewer frames.
constexpr int FewestPlainFrames = 5;

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::vector<CacheReport::Result> results;
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    for (const CacheFrames::Motion& motion : CacheFrames::AllMotions())
    {
      const int some = motion.SpaceLeaping ? frames : std::max(FewestPlainFrames, frames / 6);
      results.push_back(
        { volume, motion.Name, CacheFrames::Run(stage, motion, CacheFrames::AllVariants(), some) });
    }
  };
  if (!ForEachStage(settings,
        { { "engine.vti", 70 }, { "engine.vti", 180 }, { "brain.vti", 40 }, { "brain.vti", 90 },
          { "bonsai.vti", 40 }, { "ch2better.nii.gz", 40 }, { "spheres256", 100 },
          { "marschner-lobb256", 128 } },
        measure))
  {
    return false;
  }
  std::cout << "Cold time by the time from the image cache (plain: without space leaping)\n\n";
  CacheReport::PrintRatios(results);
  std::cout << "\nPercent of the pixels that differ from cold, median / worst frame\n\n";
  CacheReport::PrintDifferences(results);
  std::cout << "\nThe orbit of 2 degrees a frame; times in ms\n\n";
  CacheReport::PrintDetails(results, "orbit 2");
  std::cout << "\nThe same without space leaping\n\n";
  CacheReport::PrintDetails(results, "orbit 2 plain");
  CacheReport::AddTo(json, results);
  return true;
}

}

Scenario Scenarios::ImageCache()
{
  return { "image-cache", "a moving camera: frames from the image cache beside cold ones", Run };
}
