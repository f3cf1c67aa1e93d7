// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_IsomapReport_h
#define Benchmarks_IsomapReport_h

#include "IsomapFrames.h"
#include "IsomapMaps.h"
#include "Report.h"
#include "Volumes/Volumes.h"

#include <string>
#include <vector>

/// Tables and JSON of what was measured of the isomap.
namespace IsomapReport
{

/// All that was measured of one volume.
struct Result
{
  Volumes::Sample Volume;
  IsomapFrames::Times Frames;
  std::vector<IsomapMaps::Map> Widths; ///< the last is of the whole range
  std::vector<IsomapMaps::Map> Tolerances;
};

void PrintFrames(const std::vector<Result>& results);
void PrintWholeMaps(const std::vector<Result>& results);
void PrintWidths(const std::vector<Result>& results);
void PrintTolerances(const std::vector<Result>& results);

/// A list of maps.
void AddTo(JsonWriter& json, const std::string& name, const std::vector<IsomapMaps::Map>& maps);

void AddTo(JsonWriter& json, const std::vector<Result>& results);

}

#endif
