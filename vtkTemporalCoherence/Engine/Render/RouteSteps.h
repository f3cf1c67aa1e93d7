// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RouteSteps_h
#define TemporalCoherence_RouteSteps_h

#include "Render/Routes.h"
#include "Render/ShadeSceneOf.h"
#include "Render/TileLoop.h"
#include "Render/TileTracer.h"
#include "Scene/Timers.h"

#include <cstddef>
#include <cstdint>

// Steps that several routes share.

namespace TemporalCoherence
{

/// The optional planes that views made from the frame may need.
inline FrameExtras ExtrasOf(const FrameTask& task)
{
  const FrameOptions& options = task.Options;
  FrameExtras extras;
  extras.Disparities = options.Reuse.Frames && options.Accuracy == ReuseAccuracy::Paper;
  extras.Cells = task.Key.Samples.Shape->Abilities().IsMesh;
  return extras;
}

/// ExtrasOf, for a frame that copies planes of the last one: no plane that the last one lacks.
inline FrameExtras ExtrasToCopy(const FrameTask& task)
{
  const Frame& last = task.Store.Last().Picture;
  FrameExtras extras = ExtrasOf(task);
  extras.Disparities = extras.Disparities && !last.Disparities.empty();
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
  return task.Structures.SpaceToLeap(leaps);
}

inline TileScene SceneOf(const FrameTask& task, const LeapedSpace& space, const RayHint* hint)
{
  const ValueRangePyramid& ranges = task.Structures.Pyramid();
  return { task.Key, space.Active, space.Bounds, ranges.FiniteRange(), hint, &ranges };
}

inline ShadeScene ShadeSceneOf(const FrameTask& task, const LeapedSpace& space)
{
  return ShadeSceneOf(task.Key, task.Structures.Pyramid().FiniteRange(), space, task.Light);
}

/// Call work(tile, part, frame) for all tiles of the frame.
template <typename Work>
bool WorkOnTiles(FrameTask& task, const ReportProgress& report, const Work& work)
{
  Frame& frame = task.Store.Next().Picture;
  return CountGroups(frame.Size, report, task.Statistics,
    [&](std::size_t group, TraceCounts& ofGroup)
    {
      CountGroup(frame.Size, group, ofGroup,
        [&](std::int64_t tile, const PixelRect& part) { return work(tile, part, frame); });
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
