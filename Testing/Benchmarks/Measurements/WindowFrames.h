// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_WindowFrames_h
#define Benchmarks_WindowFrames_h

#include "Stage.h"

#include <string>
#include <vector>

/// What a frame costs in a render window, route by route, beside the same frame without one.
namespace WindowFrames
{

/// Medians in milliseconds; None if no frame was of the route.
struct RouteTimes
{
  std::string Route;
  double Image = 0.0;   ///< MakeImage
  double Window = 0.0;  ///< from the call of Render() until the window has drawn
  double Present = 0.0; ///< of that, the mapper's own part of showing the picture
};

struct Times
{
  std::vector<RouteTimes> Routes;
  double Picture = 0.0; ///< any other picture of this size each time, by a vtkImageActor
};

/// Needs a display (Display.h).
Times Measure(Stage& stage, int frames);

}

#endif
