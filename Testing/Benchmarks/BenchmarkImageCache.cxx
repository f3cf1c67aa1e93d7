// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Times the image cache: frames of a moving camera, cold and at each accuracy, and how far they
// differ. With --growth how times grow with the data, with --drift how errors grow with the frames.

#include "CacheReport.h"
#include "CacheScenarios.h"
#include "CommandLine.h"
#include "Drift.h"
#include "Growth.h"
#include "Measuring.h"
#include "Report.h"
#include "Stage.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace
{

struct Settings
{
  int Size = 1024;
  int Frames = 60;
  bool Growth = false;
  int Largest = 512;
  bool Drift = false;
  int DriftFrames = Drift::LongRun;
  std::string Json;
  std::vector<Volumes::Sample> Volumes = { { "engine.vti", 70 }, { "engine.vti", 180 },
    { "brain.vti", 40 }, { "brain.vti", 90 }, { "bonsai.vti", 40 }, { "ch2better.nii.gz", 40 },
    { "spheres256", 100 }, { "marschner-lobb256", 128 } };
};

/// The plain ray caster is slow: it gets fewer frames.
constexpr int FewestPlainFrames = 5;

std::vector<CacheReport::Result> RunScenarios(const Settings& settings)
{
  std::vector<CacheReport::Result> results;
  for (const Volumes::Sample& sample : settings.Volumes)
  {
    const vtkSmartPointer<vtkImageData> image = LoadOrTell(sample.Name);
    if (!image)
    {
      continue;
    }
    std::cerr << sample.Name << ' ' << sample.Isovalue << std::endl;
    Stage stage(image, sample.Isovalue, settings.Size);
    for (const CacheScenarios::Scenario& scenario : CacheScenarios::AllScenarios())
    {
      const int frames =
        scenario.SpaceLeaping ? settings.Frames : std::max(FewestPlainFrames, settings.Frames / 6);
      results.push_back({ sample, scenario.Name,
        CacheScenarios::Run(stage, scenario, CacheScenarios::AllVariants(), frames) });
    }
  }
  return results;
}

bool ReportScenarios(const Settings& settings, JsonWriter& json)
{
  const std::vector<CacheReport::Result> results = RunScenarios(settings);
  if (results.empty())
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
  std::cout << '\n';
  CacheReport::AddTo(json, results);
  return true;
}

/// The same object with more and more samples.
void ReportGrowth(const Settings& settings, JsonWriter& json)
{
  using namespace CacheScenarios;
  const std::vector<Variant> variants = { AllVariants()[0], AllVariants()[1] };
  std::cout << "An orbit of 2 degrees a frame; ";
  Growth::Report(
    { { "cold", "coldMs" }, { "BOUNDED", "boundedMs" }, { "", "framesFromCachePercent" } },
    settings.Size, settings.Largest,
    [&](Stage& stage) -> std::vector<double>
    {
      const std::vector<Summary> summaries = Run(stage, Orbit(2.0), variants, settings.Frames);
      return { summaries[0].Medians[FrameMs], summaries[1].Medians[FrameMs],
        summaries[1].FramesFromCache };
    },
    json);
}

bool ReportDrift(const Settings& settings, JsonWriter& json)
{
  if (settings.DriftFrames < Drift::Stride)
  {
    throw Measuring::Failure(
      "Give --drift-frames a number of at least " + Plain(Drift::Stride) + ".");
  }
  const Volumes::Sample& sample = settings.Volumes.front();
  const vtkSmartPointer<vtkImageData> image = LoadOrTell(sample.Name);
  if (!image)
  {
    return false;
  }
  Stage stage(image, sample.Isovalue, settings.Size);
  const std::vector<Drift::Course> courses = Drift::Run(stage, settings.DriftFrames);
  std::cout << "Percent of the pixels that differ from cold over " << settings.DriftFrames
            << " frames, " << sample.Name << ' ' << sample.Isovalue << "\n\n";
  Drift::PrintTable(courses);
  std::cout << '\n';
  json.Add("volume", sample.Name);
  json.Add("isovalue", sample.Isovalue);
  Drift::AddTo(json, courses);
  return true;
}

/// False if nothing was measured.
bool Report(const Settings& settings, JsonWriter& json)
{
  if (!settings.Growth && !settings.Drift)
  {
    return ReportScenarios(settings, json);
  }
  if (settings.Growth)
  {
    ReportGrowth(settings, json);
  }
  return (settings.Drift && ReportDrift(settings, json)) || settings.Growth;
}

}

int main(int argc, char* argv[])
{
  Settings settings;
  CommandLine options("BenchmarkImageCache",
    "Time frames from the image cache beside cold ones, as Markdown tables.");
  options.Number("--size", "pixels of the picture in each direction", settings.Size);
  options.Number("--frames", "frames of a scenario", settings.Frames);
  options.Text("--json", "write all figures to this file too", settings.Json);
  options.Flag("--growth", "instead: times for more and more samples", settings.Growth);
  options.Number("--largest", "where growth ends, samples a side", settings.Largest);
  options.Flag("--drift", "instead: errors over many frames, first volume", settings.Drift);
  options.Number("--drift-frames", "how many", settings.DriftFrames);
  options.Volumes(settings.Volumes);
  return options.Run(argc, argv,
    [&]
    {
      return MakeReport(
        settings.Size, settings.Json, [&](JsonWriter& json) { return Report(settings, json); });
    });
}
