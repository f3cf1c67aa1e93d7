// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_IsomapPlots_h
#define Benchmarks_IsomapPlots_h

#include "IsomapReport.h"

#include <string>
#include <vector>

/// Plots of what isomaps cost: build time and memory by width, memory by tolerance. Files are
/// called isomap-build, isomap-memory and isomap-tolerance, in a folder.
namespace IsomapPlots
{

void Write(const std::vector<IsomapReport::Result>& results, const std::string& folder);

}

#endif
