// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/LatticeBlending.h"

#include "Volumes/Beams/CompositeTracer.h"
#include "Volumes/Projections/ExtremeSearch.h"
#include "Volumes/Projections/ImageShares.h"
#include "Volumes/Projections/ProjectionTracer.h"
#include "Volumes/Projections/ShareTracer.h"
#include "Volumes/Samples/ConvergedTracer.h"
#include "Volumes/Samples/SampledTracer.h"
#include "Volumes/Samples/SegmentSources.h"

namespace TemporalCoherence
{
namespace
{

/// True for an image of one component without labels, with linear interpolation and no sample
/// distance.
bool IsPlain(const BlendScene& scene, const GridCoordinates* grid)
{
  const Blending& volume = scene.Key.Blended();
  return !grid && scene.Key.Samples.Between == Interpolation::Linear && volume.Others.empty() &&
    !volume.Labels && volume.SampleDistance == 0.0;
}

/// True if the range of the transfer function is not empty.
bool HasTransferRange(const Blending& volume)
{
  const glm::dvec2& range = volume.Looks.front().Transfer.Range;
  return range.x < range.y;
}

}

std::shared_ptr<const BlendTracer> MakeLatticeBlendTracer(
  const BlendScene& scene, const GridCoordinates* grid, KeptTables* kept)
{
  switch (scene.Key.Blended().Mode)
  {
    case BlendMode::Maximum:
    case BlendMode::Minimum:
      return scene.Key.Blended().SampleDistance > 0.0
        ? MakeSampledExtremes(scene, grid, &MakeSegmentSource)
        : MakeExtremeTracer(scene, grid, &MakeExtremeSearch);
    case BlendMode::Composite:
      return IsPlain(scene, grid) ? MakeCompositeTracer(scene, kept)
        : scene.Key.Blended().SampleDistance > 0.0
        ? MakeSampledTracer(scene, grid, &MakeSegmentSource)
        : MakeConvergedTracer(scene, grid, &MakeSegmentSource);
    case BlendMode::Average:
    case BlendMode::Additive:
      return IsPlain(scene, grid) && HasTransferRange(scene.Key.Blended())
        ? MakeImageShares(scene)
        : MakeShareTracer(scene, grid, &MakeSegmentSource);
    default:
      return nullptr;
  }
}

}
