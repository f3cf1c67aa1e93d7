// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RouteSteps_h
#define TemporalCoherence_RouteSteps_h

#include "Render/Routes.h"
#include "Render/TileLoop.h"
#include "Render/TileTracer.h"
#include "Scene/Timers.h"
#include "Shade/TileShader.h"

#include <cstddef>
#include <cstdint>

// What routes have in common.

namespace TemporalCoherence
{

/// What views made from the frame may need.
inline FrameExtras ExtrasOf(const FrameTask& task)
{
  const FrameOptions& options = task.Options;
  const bool isPaper = options.Accuracy == ReuseAccuracy::Paper;
  const bool isBounded =
    options.Accuracy == ReuseAccuracy::Bounded && IsFasterFrom(task.Key, task.Key);
  const bool isCached = options.Reuse.ImageCache;
  return { isCached && (isPaper || isBounded), isCached && isBounded,
    task.Key.Samples.Kind->Abilities().IsMesh };
}

/// The same for a route that finds no first entries.
inline FrameExtras ExtrasWithoutEntries(const FrameTask& task)
{
  FrameExtras extras = ExtrasOf(task);
  extras.FirstEntries = false;
  return extras;
}

/// Make room for the frame, and find out where its rays can meet surfaces.
inline LeapedSpace Begin(FrameTask& task, bool leaps, const FrameExtras& extras)
{
  Stopwatch watch(task.Statistics.TraceTime);
  if (leaps)
  {
    task.Structures.PrepareActiveCells(task.Key);
  }
  task.Store.Begin(task.Key, extras);
  if (task.Costs)
  {
    task.Costs->Resize(NumberOfGroups(task.Key.View.Size));
  }
  return task.Structures.SpaceToLeap(leaps);
}

inline TileScene SceneOf(const FrameTask& task, const LeapedSpace& space, const RayHint* hint)
{
  const ValueRangePyramid& ranges = task.Structures.Pyramid();
  return { task.Key, space.Active, space.Bounds, ranges.FiniteRange(), hint, &ranges };
}

/// Call work(tile, part, frame) for all tiles of the frame.
template <typename Work>
bool WorkOnTiles(FrameTask& task, const ReportProgress& report, const Work& work)
{
  Frame& frame = task.Store.Next().Picture;
  return CountGroups(
    frame.Size, report, task.Statistics,
    [&](std::size_t group, TraceCounts& ofGroup)
    {
      CountGroup(frame.Size, group, ofGroup,
        [&](std::int64_t tile, const PixelRect& part) { return work(tile, part, frame); });
    },
    [&](std::size_t group, std::int64_t cost)
    {
      if (task.Costs)
      {
        task.Costs->SetTraced(group, cost);
      }
    });
}

/// Call work(tile, part, frame) for all tiles of the frame, and limit the layers that are kept.
template <typename Work>
bool MakeTiles(FrameTask& task, const Work& work)
{
  Frame& made = task.Store.Next().Picture;
  LayerLimit limit(task.Options.Layers, made);
  const bool isDone = WorkOnTiles(task, task.Report,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      const TraceCounts counts = work(tile, part, frame);
      limit.Take(tile, frame);
      return counts;
    });
  if (isDone)
  {
    limit.Finish(made, task.Statistics);
  }
  return isDone;
}

}

#endif
