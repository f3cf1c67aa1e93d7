// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include "Measuring.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cstdlib>
#include <iostream>

namespace
{

bool HasDisplay()
{
  const vtkNew<vtkRenderWindow> window;
  return !window->IsA("vtkXOpenGLRenderWindow") || std::getenv("DISPLAY");
}

}

void RequireDisplay()
{
  if (!HasDisplay())
  {
    throw Measuring::Failure(
      "There is no display to draw on: put xvfb-run -a in front of the command.");
  }
}

bool HasDisplayOrTell(const std::string& whatIsLeftOut)
{
  if (!HasDisplay())
  {
    std::cerr << whatIsLeftOut
              << " left out: there is no display to draw on; put xvfb-run -a in front of the "
                 "command.\n";
    return false;
  }
  return true;
}
