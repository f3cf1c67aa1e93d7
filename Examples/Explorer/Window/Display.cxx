// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/Display.h"

#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <cstdlib>
#include <string>

#ifdef EXPLORER_HAS_X11
#include <X11/Xlib.h>
#endif

void CheckDisplay()
{
#if !defined(_WIN32) && !defined(__APPLE__)
  for (const char* other : { "WAYLAND_DISPLAY", "QT_QPA_PLATFORM" })
  {
    if (std::getenv(other))
    {
      return; // whoever chooses another way knows it
    }
  }
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    throw UserError("A window needs a display, but DISPLAY is not set; log in with ssh -X or run "
                    "under xvfb-run, or make pictures with Examples/OrbitAndSweep, which needs "
                    "none.");
  }
#ifdef EXPLORER_HAS_X11
  Display* display = XOpenDisplay(name);
  if (!display)
  {
    throw UserError("A window needs a display, but " + Quoted(std::string(name)) +
      " (DISPLAY) cannot be opened; set DISPLAY to one that runs, or make pictures with "
      "Examples/OrbitAndSweep, which needs none.");
  }
  XCloseDisplay(display);
#endif
#endif
}
