// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/UniformBlending.h"

#include "Blending/ProjectionTracer.h"

namespace TemporalCoherence
{

std::shared_ptr<const BlendTracer> MakeUniformBlendTracer(
  const BlendScene& scene, const GridCoordinates* grid)
{
  switch (scene.Key.Volume.Mode)
  {
    case BlendMode::Maximum:
    case BlendMode::Minimum:
      return MakeExtremeTracer(scene, grid);
    case BlendMode::Composite: // here goes MakeCompositeTracer(scene, grid), for one component
    default:
      return nullptr;
  }
}

}
