// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/SampledTracer.h"

#include "Volumes/Samples/LooksByLabel.h"
#include "Volumes/Samples/Medium.h"
#include "Volumes/Samples/RaySamples.h"

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Rays end once their transmittance is this small.
constexpr double LeastPassed = 1.0 / 4096.0;

class SampledTracer final : public BlendTracer
{
public:
  SampledTracer(const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
    : Key(scene.Key)
    , Looks(Key.Blended())
    , Samples(Key)
    , Cells(make(scene, grid))
  {
  }

  void Trace(const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.HasWalk(ray) && static_cast<double>(seen.Passed[ray]) > LeastPassed)
      {
        this->Blend(rays, world, ray, seen);
      }
    }
  }

private:
  void Blend(
    const RayBatch& rays, const WorldDirections& world, std::size_t ray, BlendedRays& seen) const
  {
    SegmentMedium medium(this->Key, this->Looks, *this->Cells, rays, world, ray);
    const double entry = this->Samples.EntryOf(rays, world, ray);
    glm::dvec3 color(seen.Color[0][ray], seen.Color[1][ray], seen.Color[2][ray]);
    auto passed = static_cast<double>(seen.Passed[ray]);
    seen.CellsRead += this->Cells->Visit(rays, ray,
      [&](const ComponentSegment& segment)
      {
        medium.Enter(segment);
        this->Samples.ForEach(segment, entry,
          [&](double share)
          {
            const Medium step = medium.StepAt(share, this->Samples.Distance());
            if (step.Extinction > 0.0)
            {
              seen.First[ray] = std::min(seen.First[ray], segment.DistanceAt(share));
            }
            color += passed * step.Emission;
            passed *= 1.0 - step.Extinction;
          });
        return passed > LeastPassed;
      });
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      seen.Color[channel][ray] = static_cast<float>(color[static_cast<int>(channel)]);
    }
    seen.Passed[ray] = static_cast<float>(passed);
  }

  const FrameKey& Key;
  LooksByLabel Looks;
  RaySamples Samples;
  std::unique_ptr<const SegmentSource> Cells;
};

}

std::shared_ptr<const BlendTracer> MakeSampledTracer(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
{
  return std::make_shared<SampledTracer>(scene, grid, make);
}

}
