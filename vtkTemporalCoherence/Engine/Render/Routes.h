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
#include "Shade/KeptHitValues.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The task of making one frame, for all routes.
struct FrameTask
{
  const FrameKey& Key;
  const FrameOptions& Options;
  FrameStore& Store;
  FrameStructures& Structures; ///< with the value ranges of the key
  FrameStatistics& Statistics;
  SurfaceLight* Light;     ///< that reaches the surfaces; null: all of it does
  ReportProgress Report;   ///< called with the progress, if it is not null; may stop the frame
  bool IsRepeated = false; ///< nothing has changed since the last frame
  KeptHitValues* Values =
    nullptr; ///< of the hits of the last frame, if they are shaded again; or null
};

// One function for each route. Redisplay and Reshade change the last frame in place. The others
// make the next one in FrameStore::Next(), and return false if the report stopped them. They throw
// std::bad_alloc if memory runs out.

/// Redisplay, and Antialias before its edges are made: show the last frame again.
void ShowAgain(FrameTask& task);

/// Reshade: all hits are known; only their colours change. Merged layers are traced again. If the
/// report stops it, the last frame gets its colours back.
bool ShadeAgain(FrameTask& task);

/// Cold: every ray is traced.
bool TraceCold(FrameTask& task);

/// Cold, for a blended volume: every ray is traced and blended.
bool BlendCold(FrameTask& task);

/// KeepValues: only the colours of a projection changed. The values that rays met are taken from
/// the last frame. Rays are searched if their extreme was invisible then and may be visible now.
bool BlendKnownValues(FrameTask& task);

/// True if a frame can and shall be made from fewer rays. Frames with ambient occlusion or shadows
/// are not, as they keep the light of every pixel. Colours of answers and PAPER need all rays, too.
bool CanHaveFewerRays(const FrameKey& key, const FrameOptions& options);

/// FewerRays: rays on a grid are traced, then the tiles that these predict worst. The others are
/// interpolated.
/// \param grid memory for the rays of the grid
bool TraceFewerRays(FrameTask& task, FrameStore& grid);

/// True if a frame need not wait for samples that are not read yet.
bool CanBeImpatient(const FrameKey& key, const FrameOptions& options);

/// FewerRays, for samples in bricks: tiles are traced as long as there is time. Those whose samples
/// were not read in time are shown from the stand-in.
/// \param grid memory for the rays through the stand-in
bool TraceInTime(FrameTask& task, FrameStore& grid);

/// Refine: tiles of the last frame that lie between rays are traced, the worst first. The others
/// are kept.
/// \pre the last frame has the same key
bool TraceBetweenRays(FrameTask& task);

/// ImageCache: a cached image tells where walks begin.
/// \pre the accuracy is not Exact
bool TraceFromImage(FrameTask& task, const CachedImage& image);

/// TimeStep: tiles that no changed sample affects are copied from the last frame.
bool TraceChangedTiles(FrameTask& task, const SampleComparer& changes);

/// Recomposite: only opacities changed, and perhaps the appearance. The known layers of the last
/// frame are composited again. Rays that pass the last known layer are traced from there.
/// \pre the last frame is exact
bool CompositeKnownLayers(FrameTask& task);

/// KeepLabels: other labels are drawn. Rays are traced if they met a label that is gone, may meet
/// an added one first, or pass changed samples. The others keep what they met.
/// \pre the last frame is exact, and labels are opaque in both
bool TraceChangedLabels(FrameTask& task, const SampleComparer& changes);

/// IsomapLookup and IsomapBuild: hits are looked up in tiles that have bands, and only unresolved
/// rays are traced. Some other tiles get new bands; the rest trace all rays.
/// \param map  of the view of the key
/// \param unresolved memory for the unresolved rays of each tile, one bit each
/// \param isBuilding set if some tiles had no bands before
bool LookUp(
  FrameTask& task, IsomapBuilder& map, std::vector<std::uint64_t>& unresolved, bool& isBuilding);

}

#endif
