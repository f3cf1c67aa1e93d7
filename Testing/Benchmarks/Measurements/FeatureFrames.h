// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_FeatureFrames_h
#define Benchmarks_FeatureFrames_h

#include "Stage.h"

#include <string>
#include <vector>

/// What a frame costs with a feature switched on.
namespace FeatureFrames
{

struct Times
{
  std::string Feature;
  double Cold = 0.0;   ///< median in milliseconds of cold frames of an orbit
  double Shaded = 0.0; ///< of frames in which only the light changed
};

/// One after the other; the first is the volume as it is.
std::vector<Times> Measure(Stage& stage, int frames);

}

#endif
