// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_PeerFrames_h
#define Benchmarks_PeerFrames_h

#include "Stage.h"

#include <string>
#include <vector>

/// The mapper beside what VTK has to draw an isosurface without it: the same way around the volume
/// and the same isovalues, of which slower peers draw every few.
namespace PeerFrames
{

/// Pictures of the GPU mapper are so small: without a GPU it takes very long.
constexpr int SmallSize = 128;

/// Medians in milliseconds.
struct Times
{
  std::string Who;
  bool IsOurs = false; ///< peers are compared with the last of ours before them
  int Size = 0;        ///< pixels in each direction
  double PercentDrawn = 0.0;
  double NewView = 0.0;
  double NewIsovalue = 0.0;
};

/// All of them; figures that there are not (no window, or no picture to draw) are None.
/// \param frames    of ours; peers, which are slower, draw fewer
/// \param hasWindow false: only what needs no window is measured
std::vector<Times> Measure(Stage& stage, int frames, bool hasWindow);

}

#endif
