// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// A viewer of isosurfaces, made of VTK alone: see --help.
#include "Display.h"
#include "DragMeasurement.h"
#include "ExplorerWindow.h"
#include "Options.h"
#include "Picture.h"
#include "UserError.h"

#include <cstdio>
#include <exception>

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
    std::printf("Screenshot: %s\n", options.Screenshot.c_str());
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
  try
  {
    const Options options = ParseOptions(argc, argv);
    if (options.Help)
    {
      std::fputs(HelpText().c_str(), stdout);
      return 0;
    }
    Run(options);
  }
  catch (const UserError& mistake)
  {
    std::fflush(stdout);
    std::fprintf(stderr, "Explorer: %s\n", mistake.what());
    return 1;
  }
  catch (const std::exception& failure)
  {
    std::fflush(stdout);
    std::fprintf(stderr, "Explorer: %s; try a smaller --size or volume.\n", failure.what());
    return 1;
  }
  return 0;
}
