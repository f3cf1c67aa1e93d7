// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RouteSteps_h
#define TemporalCoherence_RouteSteps_h

#include "Render/Routes.h"
#include "Render/TileLoop.h"
#include "Render/TileTracer.h"
#include "Scene/Stopwatch.h"
#include "Shade/TileShader.h"

#include <cstddef>
#include <cstdint>

// What routes have in common.

namespace TemporalCoherence
{

/// Make room for the frame, and find out where its rays can meet surfaces.
inline LeapedSpace Begin(FrameTask& task, bool leaps)
{
  Stopwatch watch(task.Statistics.TraceTime);
  if (leaps)
  {
    task.Structures.PrepareActiveCells(task.Key);
  }
  task.Store.Begin(task.Key);
  if (task.Costs)
  {
    task.Costs->Resize(NumberOfGroups(task.Key.View.Size));
  }
  return task.Structures.SpaceToLeap(leaps);
}

inline TileScene SceneOf(const FrameTask& task, const LeapedSpace& space, const RayHint* hint)
{
  // Only the free space of cached images asks for exact first entries.
  const bool isCached =
    task.Options.Reuse.ImageCache && task.Options.Accuracy == ReuseAccuracy::Bounded;
  return { task.Key, space.Active, space.Bounds, task.Structures.Pyramid().FiniteRange(), hint,
    isCached };
}

/// Call work(tile, part, frame) for all tiles of the frame.
template <typename Work>
bool WorkOnTiles(FrameTask& task, const ReportProgress& report, const Work& work)
{
  Frame& frame = task.Store.Next().Picture;
  TraceCounts counts;
  return CountGroups(
    frame.Size, report, task.Statistics, counts,
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

}

#endif
