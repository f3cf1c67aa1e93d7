// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Makes figures 5, 6 and 8 of the paper again, and a plot of the error over many frames, as PNG and
// SVG. Charts are drawn by VTK and need a display, such as xvfb-run -a gives.

#include "CommandLine.h"
#include "Figures.h"
#include "Measuring.h"
#include "Plots.h"
#include "Report.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <exception>
#include <iostream>

namespace
{

constexpr int QuickSize = 256;
constexpr int QuickFrames = 5;
constexpr int QuickDriftFrames = 120;

void MakeFigures(const Figures::Settings& settings)
{
  if (!vtksys::SystemTools::MakeDirectory(settings.Output))
  {
    throw Measuring::Failure(
      "Cannot make the folder " + settings.Output + ": name one that can be written in.");
  }
  JsonWriter json;
  AddMachine(json, settings.Size);
  Figures::AverageTimes(settings, json);
  Figures::KeyImageTimes(settings, json);
  Figures::AnswersInColor(settings, json);
  Figures::DriftOverTime(settings, json);
  json.Write(settings.Output + "/figures.json");
  std::cout << "The figures are in " << settings.Output << '\n';
}

}

int main(int argc, char* argv[])
{
  Figures::Settings settings;
  bool isQuick = false;
  CommandLine options("PaperFigures",
    "Make figures 5, 6 and 8 of the paper again, and a plot of the error over many frames.");
  options.Text("--output", "folder for figures (PNG, SVG) and figures.json", settings.Output);
  options.Number("--size", "pixels of the picture in each direction", settings.Size);
  options.Flag("--quick", "256 pixels and few frames", isQuick);
  if (!options.Read(argc, argv))
  {
    return options.ExitStatus;
  }
  if (settings.Output.empty())
  {
    std::cerr << "PaperFigures: Give --output and a folder for the figures.\n";
    return 1;
  }
  if (isQuick)
  {
    settings.Size = std::min(settings.Size, QuickSize);
    settings.Frames = QuickFrames;
    settings.DriftFrames = QuickDriftFrames;
  }
  try
  {
    Plots::RequireDisplay();
    settings.Subjects = Figures::LoadSubjects();
    MakeFigures(settings);
    return 0;
  }
  catch (const std::exception& failure)
  {
    std::cerr << failure.what() << '\n';
  }
  return 1;
}
