// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Times the isomap: new isovalues in a still view, one by one and dragged, beside cold frames, and
// what maps cost. With --window also in a render window, with --growth how times grow with the
// data.

#include "CommandLine.h"
#include "Display.h"
#include "Growth.h"
#include "IsomapDrags.h"
#include "IsomapFrames.h"
#include "IsomapMaps.h"
#include "IsomapReport.h"
#include "IsomapWindow.h"
#include "Report.h"
#include "Stage.h"

#include <iostream>
#include <string>
#include <vector>

namespace
{

struct Settings
{
  int Size = 1024;
  int Frames = 40;
  int Steps = IsomapDrags::LongRun;
  bool Window = false;
  bool Growth = false;
  int Largest = 512;
  std::string Json;
  std::vector<Volumes::Sample> Volumes = { { "engine.vti", 70 }, { "engine.vti", 180 },
    { "brain.vti", 40 }, { "brain.vti", 90 }, { "bonsai.vti", 40 }, { "ch2better.nii.gz", 40 },
    { "spheres128", 100 }, { "spheres256", 100 }, { "spheres512", 100 },
    { "marschner-lobb128", 128 }, { "marschner-lobb256", 128 }, { "marschner-lobb512", 128 } };
};

std::vector<IsomapReport::Result> MeasureVolumes(const Settings& settings)
{
  std::vector<IsomapReport::Result> results;
  for (const Volumes::Sample& sample : settings.Volumes)
  {
    const vtkSmartPointer<vtkImageData> image = LoadOrTell(sample.Name);
    if (!image)
    {
      continue;
    }
    std::cerr << sample.Name << ' ' << sample.Isovalue << std::endl;
    Stage stage(image, sample.Isovalue, settings.Size);
    IsomapReport::Result result;
    result.Volume = sample;
    result.Frames = IsomapFrames::Measure(stage, settings.Frames);
    for (const IsomapDrags::Course& course : IsomapDrags::AllCourses(stage, settings.Steps))
    {
      result.Drags.push_back(IsomapDrags::Run(stage, course));
    }
    result.Widths = IsomapMaps::MeasureWidths(stage);
    result.Tolerances = IsomapMaps::MeasureTolerances(stage);
    if (settings.Window)
    {
      result.Window = IsomapWindow::Measure(stage, settings.Frames);
    }
    results.push_back(result);
  }
  return results;
}

bool ReportVolumes(const Settings& settings, JsonWriter& json)
{
  const std::vector<IsomapReport::Result> results = MeasureVolumes(settings);
  if (results.empty())
  {
    return false;
  }
  std::cout << "One frame; medians in ms (plain: without space leaping)\n\n";
  IsomapReport::PrintFrames(results);
  std::cout << "\nDrags of the isovalue; times in ms\n\n";
  IsomapReport::PrintDrags(results);
  std::cout << "\nA map of the whole range of values; times in ms\n\n";
  IsomapReport::PrintWholeMaps(results);
  std::cout << '\n';
  IsomapReport::PrintWidths(results);
  IsomapReport::PrintTolerances(results);
  if (settings.Window)
  {
    std::cout << "In a render window; medians in ms\n\n";
    IsomapReport::PrintWindows(results);
    std::cout << '\n';
  }
  IsomapReport::AddTo(json, results);
  return true;
}

/// The same object with more and more samples.
void ReportGrowth(const Settings& settings, JsonWriter& json)
{
  std::cout << "New isovalues in a still view; ";
  Growth::Report(
    { { "cold", "coldMs" }, { "first step", "firstStepUpMs" }, { "look-up", "lookupMs" },
      { "", "bytesAPixel" } },
    settings.Size, settings.Largest,
    [&](Stage& stage) -> std::vector<double>
    {
      const IsomapFrames::Times times = IsomapFrames::Measure(stage, settings.Frames);
      return { times.Cold, times.FirstUp, times.Lookup, times.BytesAPixel };
    },
    json);
}

bool Report(const Settings& settings, JsonWriter& json)
{
  if (settings.Window)
  {
    RequireDisplay();
  }
  if (settings.Growth)
  {
    ReportGrowth(settings, json);
    return true;
  }
  return ReportVolumes(settings, json);
}

}

int main(int argc, char* argv[])
{
  Settings settings;
  CommandLine options("BenchmarkIsomap",
    "Time new isovalues from the isomap beside cold frames, as Markdown tables.");
  options.Number("--size", "pixels of the picture in each direction", settings.Size);
  options.Number("--frames", "frames of each kind", settings.Frames);
  options.Number("--steps", "isovalues of a drag", settings.Steps);
  options.Text("--json", "write all figures to this file too", settings.Json);
  options.Flag("--window", "measure in a render window too", settings.Window);
  options.Flag("--growth", "instead: times for more and more samples", settings.Growth);
  options.Number("--largest", "where growth ends, samples a side", settings.Largest);
  options.Volumes(settings.Volumes);
  return options.Run(argc, argv,
    [&]
    {
      return MakeReport(
        settings.Size, settings.Json, [&](JsonWriter& json) { return Report(settings, json); });
    });
}
