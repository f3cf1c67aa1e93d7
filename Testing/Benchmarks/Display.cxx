// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include "Measuring.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cstdlib>

void RequireDisplay()
{
  const vtkNew<vtkRenderWindow> window;
  if (window->IsA("vtkXOpenGLRenderWindow") && !std::getenv("DISPLAY"))
  {
    throw Measuring::Failure(
      "There is no display to draw on: put xvfb-run -a in front of the command.");
  }
}
