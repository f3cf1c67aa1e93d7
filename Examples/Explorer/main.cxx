// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// A viewer of isosurfaces, made of VTK alone: see --help.
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Picture.h"
#include "Window/Display.h"
#include "Window/DragMeasurement.h"
#include "Window/ExplorerWindow.h"
#include "Window/Options.h"

#include <cstdio>

namespace
{

Session FirstSession(const Options& options)
{
  Session session;
  if (options.StartsWithSession)
  {
    session = ReadSession(options.SessionFile);
  }
  else
  {
    session.Source = options.Source;
  }
  if (options.Isovalue)
  {
    session.Isovalue = options.Isovalue;
  }
  if (options.ThresholdMode)
  {
    session.Choices[Choose::Surface] = vtkTemporalCoherenceVolumeMapper::THRESHOLD;
  }
  return session;
}

void Run(const Options& options)
{
  const Session session = FirstSession(options);
  CheckDisplay();
  ExplorerWindow window(options);
  window.Open(session);
  if (!options.Screenshot.empty())
  {
    window.Render();
    WritePng(window.PictureOfWindow(), options.Screenshot, "name another file with --screenshot");
    std::printf("Screenshot: %s\n", Printable(options.Screenshot).c_str());
  }
  else if (options.MeasuredDrag > 0)
  {
    MeasureDrag(window, options.MeasuredDrag);
  }
  else
  {
    window.Run();
  }
}

}

int main(int argc, char* argv[])
{
  return RunProgram("Explorer",
    [&]
    {
      const Options options = ParseOptions(argc, argv);
      if (options.Help)
      {
        std::fputs(HelpText().c_str(), stdout);
        return;
      }
      Run(options);
    });
}
