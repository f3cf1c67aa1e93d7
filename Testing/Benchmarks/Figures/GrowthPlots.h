// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_GrowthPlots_h
#define Benchmarks_GrowthPlots_h

#include "GrowthSteps.h"
#include "ThreadFrames.h"

#include <string>
#include <utility>
#include <vector>

/// Plots of how times grow with the data and fall with threads.
namespace GrowthPlots
{

/// Times of frames by the samples of an object.
void TimesByVoxels(const std::vector<GrowthSteps::Step>& steps, const std::string& path);

/// A volume's name, and its frames with more and more threads.
using VolumeThreads = std::pair<std::string, std::vector<ThreadFrames::Times>>;

/// Speed-ups by threads; nothing where there is only one.
void SpeedUpByThreads(const std::vector<VolumeThreads>& volumes, const std::string& path);

}

#endif
