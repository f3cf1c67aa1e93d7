// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Layout_h
#define Layout_h

#include "Drawing/Canvas.h"

// Where everything goes in a window of a size. Parts never overlap, but for what lies on the view
// for a while. In windows too small for it there is no bar.
struct Layout
{
  Layout(int width, int height);

  Rect View;
  Rect Isovalue;
  Rect Statistics;
  Rect Switches;
  Rect Message; // as high as it may become
  Rect Progress;
  Rect List; // help and files
  int RowHeight = 0;
};

#endif
