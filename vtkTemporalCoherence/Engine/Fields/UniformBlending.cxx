// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/UniformBlending.h"

#include "Composite/CompositeTracer.h"
#include "Fields/ExtremeSearches.h"
#include "Fields/SegmentSources.h"
#include "Projections/ImageShares.h"
#include "Projections/ProjectionTracer.h"
#include "Projections/ShareTracer.h"
#include "Sampling/ConvergedTracer.h"
#include "Sampling/SampledTracer.h"

namespace TemporalCoherence
{
namespace
{

/// True if a volume has one component on the grid of an image, and its picture may converge.
bool IsPlain(const BlendScene& scene, const GridCoordinates* grid)
{
  const Blending& volume = scene.Key.Volume;
  return !grid && scene.Key.Samples.Between == Interpolation::Linear && volume.Others.empty() &&
    volume.SampleDistance == 0.0;
}

/// True if colours depend on values.
bool HasTransferRange(const Blending& volume)
{
  const glm::dvec2& range = volume.Looks.front().Transfer.Range;
  return range.x < range.y;
}

}

std::shared_ptr<const BlendTracer> MakeUniformBlendTracer(
  const BlendScene& scene, const GridCoordinates* grid)
{
  switch (scene.Key.Volume.Mode)
  {
    case BlendMode::Maximum:
    case BlendMode::Minimum:
      return scene.Key.Volume.SampleDistance > 0.0
        ? MakeSampledExtremes(scene, grid, &MakeSegmentSource)
        : MakeExtremeTracer(scene, grid, &MakeExtremeSearch);
    case BlendMode::Composite:
      return IsPlain(scene, grid) ? MakeCompositeTracer(scene)
        : scene.Key.Volume.SampleDistance > 0.0
        ? MakeSampledTracer(scene, grid, &MakeSegmentSource)
        : MakeConvergedTracer(scene, grid, &MakeSegmentSource);
    case BlendMode::Average:
    case BlendMode::Additive:
      return IsPlain(scene, grid) && HasTransferRange(scene.Key.Volume)
        ? MakeImageShares(scene)
        : MakeShareTracer(scene, grid, &MakeSegmentSource);
    default:
      return nullptr;
  }
}

}
