// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_GrowthFigures_h
#define Benchmarks_GrowthFigures_h

#include "Figures.h"
#include "Report.h"

/// Plots of what the paper has no figures of. As in Figures, each function prints its numbers as a
/// table, adds them to the report and writes its files into the output folder.
namespace GrowthFigures
{

/// Times of a frame with more and more samples.
void TimesByVoxels(const Figures::Settings& settings, JsonWriter& json);

/// By how much more threads are faster; nothing where there is one thread only.
void SpeedUpByThreads(const Figures::Settings& settings, JsonWriter& json);

}

#endif
