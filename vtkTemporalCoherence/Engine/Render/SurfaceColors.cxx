// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/RayColors.h"
#include "Render/RouteSteps.h"

#include <algorithm>
#include <array>

namespace TemporalCoherence
{
namespace
{

/// Colours of isosurfaces, by the tracer and the shader of cold frames.
class SurfaceColors : public RayColors
{
public:
  SurfaceColors(const FrameTask& task, const LeapedSpace& space, SurfaceLight* light)
    : Tracer(SceneOf(task, space, nullptr))
    , Shader(ShadeSceneOf(task.Key, task.Structures.Pyramid().FiniteRange(), space, light),
        HitSet::All, HitSet::All)
  {
  }

  TraceCounts Find(std::int64_t tile, const LooseRays& rays, Frame& made) const override
  {
    TraceCounts counts;
    TileHits found;
    if (this->Tracer.TraceAt(tile, rays, found))
    {
      counts.CellsRead += found.Hits.CellsRead;
      this->Shader.ShadeAt(tile, rays.At, found, made, counts);
    }
    else
    {
      std::fill(made.Colors.begin(), made.Colors.end(), std::array<std::uint8_t, 4>{});
    }
    return counts;
  }

private:
  TileTracer Tracer;
  TileShader Shader;
};

}

std::unique_ptr<RayColors> MakeSurfaceColors(FrameTask& task, SurfaceLight* light)
{
  const bool leaps = task.Options.SpaceLeaping;
  if (leaps)
  {
    task.Structures.PrepareActiveCells(task.Key);
  }
  return std::make_unique<SurfaceColors>(task, task.Structures.SpaceToLeap(leaps), light);
}

}
