// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Routes_h
#define TemporalCoherence_Routes_h

#include "Acceleration/SampleComparer.h"
#include "Isomap/IsomapBuilder.h"
#include "Render/FrameOptions.h"
#include "Render/FrameStatistics.h"
#include "Render/FrameStore.h"
#include "Render/FrameStructures.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A frame that is to be made: what it is of, and what there is to make it with.
struct FrameTask
{
  const FrameKey& Key;
  const FrameOptions& Options;
  FrameStore& Store;
  FrameStructures& Structures; ///< with the value ranges of the key
  FrameStatistics& Statistics;
  ReportProgress Report;      ///< told how far the frame is, if it is not null; may stop it
  std::int64_t CellsRead = 0; ///< by the rays that were traced
};

// One function for each route. Those that give the last frame other colours, or none, change it in
// place. The others make the next one in FrameStore::Next(); false if the report stopped them.
// Where memory ends they throw std::bad_alloc.

/// Redisplay: the last frame is the frame.
void ShowAgain(FrameTask& task);

/// Reshade: all hits are known, only their colours change.
void ShadeAgain(FrameTask& task);

/// Cold: every ray is traced.
bool TraceCold(FrameTask& task);

/// ThresholdHint: the hits of the last frame bound the search for another isovalue.
bool TraceWithLastHits(FrameTask& task);

/// ImageCache: rays start from what a kept image tells.
/// \pre the accuracy is not Exact
bool TraceFromImage(FrameTask& task, CachedImage& image);

/// TimeStep: tiles that see none of the samples that changed are copied from the last frame.
bool TraceChangedTiles(FrameTask& task, const SampleComparer& changes);

/// IsomapLookup: hits are looked up, and only what the isomap cannot tell is traced.
/// \param map  covers the isovalues of the key
/// \param unresolved memory for the rays of each tile that have to be traced, one bit each
bool LookUp(FrameTask& task, IsomapBuilder& map, std::vector<std::uint64_t>& unresolved);

}

#endif
