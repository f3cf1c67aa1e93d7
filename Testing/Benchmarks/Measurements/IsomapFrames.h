// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_IsomapFrames_h
#define Benchmarks_IsomapFrames_h

#include "Stage.h"

/// Single frames of a new isovalue: from the isomap, and cold.
namespace IsomapFrames
{

/// Medians in milliseconds. The stage's isovalue is where all of them begin.
struct Times
{
  double Cold = 0.0;  ///< an orbit
  double Plain = 0.0; ///< the same without space leaping, the paper's ray caster
  /// The first new isovalue of a new mapper after one frame: 1/256 of the range of values up, or
  /// down. Its band of the isomap is built.
  double FirstUp = 0.0;
  double FirstDown = 0.0;
  double Lookup = 0.0; ///< isovalues within that first step up; None if none is looked up
  double LookupTrace = 0.0;
  double LookupShade = 0.0;
  double BytesAPixel = 0.0; ///< of the first band up
};

/// The stage's camera moves, its isovalue comes back.
Times Measure(Stage& stage, int frames);

/// The same in the stage's view and upwards only: no cold and no plain frames, no step down.
Times MeasureStepUp(Stage& stage, int frames);

/// Bytes of a mapper's isomap by the pixels of the stage's picture.
double BytesAPixel(const Drawer& drawer, const Stage& stage);

/// Knots of a mapper's isomap by the pixels of the stage's picture.
double KnotsAPixel(const Drawer& drawer, const Stage& stage);

}

#endif
