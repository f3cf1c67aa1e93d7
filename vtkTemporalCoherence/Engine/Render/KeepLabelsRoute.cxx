// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/KeptLabels.h"
#include "Render/RouteSteps.h"

namespace TemporalCoherence
{

bool TraceChangedLabels(FrameTask& task, const SampleComparer& changes)
{
  const LeapedSpace space = Begin(task, task.Options.SpaceLeaping, ExtrasToCopy(task));
  const KeptLabels kept(task, changes);
  const TileTracer tracer(SceneOf(task, space, nullptr));
  const TileShader shader(ShadeSceneOf(task, space), HitSet::NotDefinite, HitSet::All);
  return MakeTiles(task,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      const std::uint64_t which = kept.ToTrace(tile, part);
      TraceCounts counts = kept.Copy(tile, part, which, frame);
      if (which != 0)
      {
        counts += tracer.TraceSome(tile, part, which, frame, kept.Before());
      }
      shader.Shade(tile, part, nullptr, frame, counts);
      return counts;
    });
}

}
