// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Makes figures 5 to 9 of the paper again, beside the paper's own numbers: plots and pictures as
// PNG and SVG, tables as Markdown. Charts are drawn by VTK and need a display, such as xvfb-run -a
// gives.

#include "CommandLine.h"
#include "Display.h"
#include "Figures.h"
#include "IsomapFigures.h"
#include "Measuring.h"
#include "Report.h"

#include <algorithm>
#include <iostream>

namespace
{

constexpr int QuickSize = 256;
constexpr int QuickFrames = 5;

void MakeFigures(Figures::Settings settings, bool isQuick)
{
  if (settings.Output.empty())
  {
    throw Measuring::Failure("Give --output and a folder for the figures.");
  }
  RequireDisplay();
  RequireFolder(settings.Output);
  settings.Subjects = Figures::LoadSubjects(isQuick);
  JsonWriter json;
  AddMachine(json, settings.Size);
  Figures::AverageTimes(settings, json);
  Figures::KeyImageTimes(settings, json);
  Figures::AnswersInColor(settings, json);
  IsomapFigures::ThresholdTimes(settings, json);
  IsomapFigures::TwoThresholds(settings, json);
  json.Write(settings.Output + "/figures.json");
  std::cout << "The figures are in " << settings.Output << '\n';
}

}

int main(int argc, char* argv[])
{
  Figures::Settings settings;
  bool isQuick = false;
  CommandLine options(
    "PaperFigures", "Make figures 5 to 9 of the paper again, beside the paper's own numbers.");
  options.Text("--output", "folder for figures (PNG, SVG) and figures.json", settings.Output);
  options.Number("--size", "pixels of the picture in each direction", settings.Size);
  options.Flag("--quick", "256 pixels, few frames and one small volume", isQuick);
  return options.Run(argc, argv,
    [&]
    {
      if (isQuick)
      {
        settings.Size = std::min(settings.Size, QuickSize);
        settings.Frames = QuickFrames;
      }
      MakeFigures(settings, isQuick);
      return true;
    });
}
