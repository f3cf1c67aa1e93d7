// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_IsomapMaps_h
#define Benchmarks_IsomapMaps_h

#include "Stage.h"

#include <vector>

/// Isomaps of one band, built ahead: what they cost by their width and by their tolerance.
namespace IsomapMaps
{

/// For maps that nobody would ask for, too.
constexpr int LargeMemoryLimit = 8192; ///< MiB

/// A band that was built by BuildIsomap.
struct Map
{
  double Width = 0.0;     ///< share of the range of values
  double Tolerance = 0.0; ///< voxels
  bool IsBuilt = false;   ///< false: it does not fit the memory, and all below is 0
  double ColdMs = 0.0;    ///< a cold frame of the stage's isovalue
  double BuildMs = 0.0;
  double BytesAPixel = 0.0;
  double KnotsAPixel = 0.0;
  double LookupMs = 0.0;     ///< median of isovalues all over the band
  double LookupColdMs = 0.0; ///< the same of cold frames of these isovalues
  /// Of these look-ups, against cold frames: the farthest surface, and the pixels with another one.
  double VoxelsApart = 0.0;
  double PercentDifferent = 0.0; ///< worst frame; as PercentDifferent of Stage
};

/// Maps of more and more values around the stage's isovalue, from 0.1 % to all,
/// which is the last.
std::vector<Map> MeasureWidths(Stage& stage);

/// Maps of the whole range with tolerances from 0 to 2 voxels.
std::vector<Map> MeasureTolerances(Stage& stage);

}

#endif
