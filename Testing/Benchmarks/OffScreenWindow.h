// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_OffScreenWindow_h
#define Benchmarks_OffScreenWindow_h

#include <vtkNew.h>
#include <vtkRenderWindow.h>

class vtkRenderer;

/// A render window that nobody sees, with one renderer. It needs a display (Display.h).
class OffScreenWindow
{
public:
  /// \param size pixels in each direction
  OffScreenWindow(vtkRenderer* renderer, int size);

  /// Milliseconds from the call of Render() until the window has drawn.
  double Draw();

  /// Share in percent of the pixels in which something is seen.
  double PercentDrawn();

private:
  const int Size;
  vtkNew<vtkRenderWindow> Window;
};

#endif
