// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Floor_h
#define Benchmarks_Floor_h

#include "Stage.h"

/// The floor of a frame: what it takes to draw hits whose cells are known (KernelsFloor.h). A frame
/// that costs as much as this would have found all hits for nothing.
namespace Floor
{

struct Times
{
  double Hits = 0.0;
  double Milliseconds = 0.0; ///< median of wall time, all threads
  double PerHit = 0.0;       ///< nanoseconds of all threads together, the least of all frames
};

/// Draw the hits of the stage's isovalue in its view.
/// \return figures that are Measuring::None if samples are not bytes, shorts or floats, not
///         adjacent along x, or fewer than four along an axis
/// \throws Measuring::Failure if the image is not one that the mapper can see
Times Measure(Stage& stage, int frames);

}

#endif
