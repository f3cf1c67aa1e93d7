// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_DriftPlot_h
#define Benchmarks_DriftPlot_h

#include "Drift.h"

#include <string>
#include <vector>

/// How far pictures part from the cold ones over many frames: what the paper could not measure.
/// \param size pixels of the pictures in each direction
/// \param path of the plot, without the ending
void PlotDrift(const std::vector<Drift::Curve>& curves, const std::string& volume, int size,
  const std::string& path);

#endif
