// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_IsomapDrags_h
#define Benchmarks_IsomapDrags_h

#include "Stage.h"

#include <string>
#include <vector>

/// A threshold that is dragged: isovalue after isovalue in a still view, every frame beside cold
/// ones of the same isovalue.
namespace IsomapDrags
{

/// Isovalues one after the other; the first is where the drag begins.
struct Path
{
  std::string Name;
  std::vector<double> Isovalues;
};

/// In steps of 0.2, 1 and 5 % of the range of values, up and back between its ends; in steps of
/// 0.4 % around the stage's isovalue; and anywhere in the range, at random.
std::vector<Path> AllPaths(const Stage& stage, int steps);

/// One path, gone twice, each time by a new mapper. Frames are measured in CPU time of all threads,
/// by that of a cold frame of the same isovalue whose structures are there. Measured times decide
/// which frame builds a band, so the frames of the two do not match one by one. Of each figure the
/// lesser counts: the worst frame is to be one that takes long, not one that was disturbed.
struct Summary
{
  std::string Path;
  int Steps = 0;
  double First = 0.0; ///< the first new isovalue
  double Mean = 0.0;
  double NearlyWorst = 0.0; ///< 95 % of the frames take no longer
  double Worst = 0.0;
  double WorstAt = 0.0;       ///< isovalue of that frame
  double MeanOfNew = 0.0;     ///< cold frames that make structures of their isovalue
  double ColdMs = 0.0;        ///< median of the cold frames, CPU time
  double PercentTraced = 0.0; ///< rays traced, by those of the cold frames
  double BytesAPixel = 0.0;   ///< the most in any frame
  int Different = 0;          ///< pictures that are not the cold one to the last bit
};

/// Drag the stage's isovalue, which comes back.
Summary Run(Stage& stage, const Path& path);

}

#endif
