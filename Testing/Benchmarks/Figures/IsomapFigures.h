// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_IsomapFigures_h
#define Benchmarks_IsomapFigures_h

#include "Figures.h"
#include "Report.h"

/// The paper's figures of the isomap. As in Figures, each function prints its
/// numbers as a table, adds them to the report and writes its files into the output folder.
namespace IsomapFigures
{

/// Figure 7: the time of a picture without an isomap, of building it, and of one threshold after
/// the other.
void ThresholdTimes(const Figures::Settings& settings, JsonWriter& json);

/// Figure 9: two thresholds from one isomap.
void TwoThresholds(const Figures::Settings& settings, JsonWriter& json);

}

#endif
