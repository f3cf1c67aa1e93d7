// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_IsomapDrags_h
#define Benchmarks_IsomapDrags_h

#include "Stage.h"

#include <string>
#include <vector>

/// A threshold that is dragged: isovalue after isovalue in a still view, every picture compared
/// with a cold one.
namespace IsomapDrags
{

/// Isovalues one after the other; the first is where the drag begins.
struct Path
{
  std::string Name;
  std::vector<double> Isovalues;
};

/// In steps of 0.4 % of the range of values through its middle, up and down; and of 0.1 % around
/// the stage's isovalue, up, down through it and back.
std::vector<Path> AllPaths(const Stage& stage, int steps);

/// One path, drawn by a new mapper.
struct Summary
{
  std::string Path;
  int Steps = 0;
  double PercentBuilt = 0.0; ///< of the frames: those that built a band
  double MedianMs = 0.0;
  double MeanMs = 0.0;
  double WorstMs = 0.0;
  double WorstByCold = 0.0; ///< the largest quotient by a cold frame of the same isovalue
  double WorstAt = 0.0;     ///< isovalue of that frame
  double ColdMs = 0.0;      ///< median of the cold frames of all these isovalues
  double MeanByCold = 0.0;  ///< all frames by all cold frames
  double BytesAPixel = 0.0; ///< in the end
  int Different = 0;        ///< pictures that are not the cold one to the last bit
};

/// Drag the stage's isovalue, which comes back.
Summary Run(Stage& stage, const Path& path);

}

#endif
