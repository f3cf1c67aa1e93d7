// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// The Explorer, with options for those who test it: --log FILE tells scripts what it does,
// --measure-drag N drags the isovalue in N steps, prints what a frame took beside showing any
// picture of the view's size, and ends. --measure-stalls uses the blended volume, prints how long
// events waited, and ends.
#include "DragMeasurement.h"
#include "ScriptLog.h"
#include "StallMeasurement.h"
#include "Window/Program.h"

int main(int argc, char* argv[])
{
  std::string log;
  int steps = 0;
  bool measuresStalls = false;
  Extension tests;
  tests.AddOptions = [&](CommandLine& line)
  {
    line.AddSetting("--log", [&](const std::string&, const std::string& path) { log = path; });
    line.AddSetting("--measure-drag",
      [&](const std::string& option, const std::string& count)
      { steps = ParseCount(option, count, 100000); });
    line.AddSwitch("--measure-stalls", [&] { measuresStalls = true; });
  };
  tests.Begin = [&](MainWindow& window, Workbench& bench)
  {
    if (!log.empty())
    {
      new ScriptLog(log, window, bench);
    }
  };
  tests.First = [&](MainWindow& window, Workbench& bench)
  {
    if (steps > 0)
    {
      MeasureDrag(window, bench, steps);
      window.close();
    }
    if (measuresStalls)
    {
      MeasureStalls(window, bench);
      window.close();
    }
  };
  return RunExplorer(argc, argv, tests);
}
