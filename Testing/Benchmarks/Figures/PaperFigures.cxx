// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Makes figures 5 to 9 of the paper again, and plots of the error over many frames, of what isomaps
// cost and of growth, as PNG and SVG. Charts are drawn by VTK and need a display, such as
// xvfb-run -a gives.

#include "CommandLine.h"
#include "Display.h"
#include "FeatureFigures.h"
#include "Figures.h"
#include "GrowthFigures.h"
#include "IsomapFigures.h"
#include "Measuring.h"
#include "Report.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <iostream>

namespace
{

constexpr int QuickSize = 256;
constexpr int QuickFrames = 5;
constexpr int QuickDriftFrames = 120;
constexpr int QuickLargest = 256;

void MakeFigures(Figures::Settings settings)
{
  if (settings.Output.empty())
  {
    throw Measuring::Failure("Give --output and a folder for the figures.");
  }
  RequireDisplay();
  if (!vtksys::SystemTools::MakeDirectory(settings.Output))
  {
    throw Measuring::Failure(
      "Cannot make the folder " + settings.Output + ": name one that can be written in.");
  }
  settings.Subjects = Figures::LoadSubjects();
  JsonWriter json;
  AddMachine(json, settings.Size);
  Figures::AverageTimes(settings, json);
  Figures::KeyImageTimes(settings, json);
  Figures::AnswersInColor(settings, json);
  Figures::DriftOverTime(settings, json);
  IsomapFigures::ThresholdTimes(settings, json);
  IsomapFigures::TwoThresholds(settings, json);
  IsomapFigures::CostOfWidth(settings, json);
  IsomapFigures::CostOfTolerance(settings, json);
  FeatureFigures::SeenThroughAndCutOpen(settings);
  GrowthFigures::TimesByVoxels(settings, json);
  GrowthFigures::SpeedUpByThreads(settings, json);
  json.Write(settings.Output + "/figures.json");
  std::cout << "The figures are in " << settings.Output << '\n';
}

}

int main(int argc, char* argv[])
{
  Figures::Settings settings;
  bool isQuick = false;
  CommandLine options("PaperFigures",
    "Make figures 5 to 9 of the paper again, and plots of errors, the isomap's costs and growth.");
  options.Text("--output", "folder for figures (PNG, SVG) and figures.json", settings.Output);
  options.Number("--size", "pixels of the picture in each direction", settings.Size);
  options.Flag("--quick", "256 pixels and few frames", isQuick);
  return options.Run(argc, argv,
    [&]
    {
      if (isQuick)
      {
        settings.Size = std::min(settings.Size, QuickSize);
        settings.Frames = QuickFrames;
        settings.DriftFrames = QuickDriftFrames;
        settings.Largest = QuickLargest;
      }
      MakeFigures(settings);
      return true;
    });
}
