// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/ProjectionTracer.h"

#include "Volumes/Medium/VisibleBands.h"
#include "Volumes/Projections/ExtremeLook.h"
#include "Volumes/Samples/RaySamples.h"

#include <cmath>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Finds extremes exactly.
class ExtremeTracer final : public ExtremeLook
{
public:
  ExtremeTracer(const BlendScene& scene, const GridCoordinates* grid, ExtremeSearchMaker make)
    : ExtremeLook(scene, grid)
  {
    const ValueBand visible = VisibleExtremes(this->Volume);
    const double least = this->IsMinimum() ? visible.High : visible.Low;
    for (std::size_t part = 0; part < this->Looks.Parts(); ++part)
    {
      const std::size_t component = this->Looks.OpacityOf(part);
      const bool isFirst = component == 0;
      this->Searches.push_back(
        make({ isFirst ? scene.Key.Samples : this->Volume.Others[component - 1],
          isFirst ? scene.Ranges : nullptr, grid, this->IsMinimum(), least }));
    }
  }

  void Trace(const RayBatch& rays, const WorldDirections&, BlendedRays& seen) const override
  {
    for (std::size_t part = 0; part < this->Searches.size(); ++part)
    {
      RayBatch::Array<double> first;
      first.fill(Infinity);
      this->Searches[part]->Search(
        rays, { ValueOf(seen, part), part == 0 ? seen.First : first, seen.CellsRead });
    }
  }

private:
  std::vector<std::unique_ptr<const ExtremeSearch>> Searches; ///< one for each part
};

/// Finds the extremes of samples at a fixed distance.
class SampledExtremes final : public ExtremeLook
{
public:
  SampledExtremes(const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
    : ExtremeLook(scene, grid)
    , Samples(scene.Key)
    , Cells(make(scene, grid))
  {
  }

  void Trace(const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.HasWalk(ray))
      {
        const double entry = this->Samples.EntryOf(rays, world, ray);
        seen.CellsRead += this->Cells->Visit(rays, ray,
          [&](const ComponentSegment& segment)
          {
            this->Samples.ForEach(
              segment, entry, [&](double share) { this->Widen(segment, share, ray, seen); });
            return true;
          });
      }
    }
  }

private:
  void Widen(
    const ComponentSegment& segment, double share, std::size_t ray, BlendedRays& seen) const
  {
    for (std::size_t part = 0; part < this->Looks.Parts(); ++part)
    {
      const double value = segment.ValueAt(this->Looks.OpacityOf(part), share);
      double& extreme = ValueOf(seen, part)[ray];
      if (std::isnan(extreme) || (this->IsMinimum() ? value < extreme : value > extreme))
      {
        extreme = value;
        seen.First[ray] = part == 0 ? segment.DistanceAt(share) : seen.First[ray];
      }
    }
  }

  RaySamples Samples;
  std::unique_ptr<const SegmentSource> Cells;
};

}

std::shared_ptr<const BlendTracer> MakeExtremeTracer(
  const BlendScene& scene, const GridCoordinates* grid, ExtremeSearchMaker make)
{
  return std::make_shared<ExtremeTracer>(scene, grid, make);
}

std::shared_ptr<const BlendTracer> MakeSampledExtremes(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
{
  return std::make_shared<SampledExtremes>(scene, grid, make);
}

}
