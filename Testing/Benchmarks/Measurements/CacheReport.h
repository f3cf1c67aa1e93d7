// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_CacheReport_h
#define Benchmarks_CacheReport_h

#include "CacheFrames.h"
#include "Report.h"
#include "Volumes/Volumes.h"

#include <string>
#include <vector>

/// Tables and JSON of what CacheFrames measured.
namespace CacheReport
{

/// One volume in one motion.
struct Result
{
  Volumes::Sample Volume;
  std::string Motion;
  std::vector<CacheFrames::Summary> Summaries; ///< a variant each, the cold one first
};

/// Cold time by cached time: volumes and accuracies down, motions across.
void PrintRatios(const std::vector<Result>& results);

/// Percent of the pixels that differ from cold, median and worst frame, in the same order.
void PrintDifferences(const std::vector<Result>& results);

/// All that was measured in one motion.
void PrintDetails(const std::vector<Result>& results, const std::string& motion);

void AddTo(JsonWriter& json, const std::vector<Result>& results);

}

#endif
