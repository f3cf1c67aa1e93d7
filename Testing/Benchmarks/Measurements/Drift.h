// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Drift_h
#define Benchmarks_Drift_h

#include "Report.h"
#include "Stage.h"

#include <vector>

/// How pictures that are made from each other, frame after frame, part from the cold ones.
namespace Drift
{

constexpr int LongRun = 720; ///< frames
constexpr int Stride = 10;   ///< frames from one comparison to the next

/// One orbit.
struct Curve
{
  double Degrees = 0.0; ///< a frame
  std::vector<int> Frames;
  std::vector<double> Different; ///< percent of the pixels at these frames
};

/// PAPER over orbits of 0.5, 1 and 5 degrees a frame, always from the latest image.
std::vector<Curve> Run(Stage& stage, int frames);

/// How far each curve had parted after 20, 180, 360 and 720 frames, its median and its worst.
void PrintTable(const std::vector<Curve>& curves);

void AddTo(JsonWriter& json, const std::vector<Curve>& curves);

}

#endif
