// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Projections/ProjectionTracer.h"

#include "Blending/ComponentLooks.h"
#include "Blending/RaySamples.h"
#include "Blending/TransferLookup.h"
#include "Projections/FieldProbe.h"

#include <cmath>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Nothing = std::numeric_limits<double>::quiet_NaN();

/// What a component adds to a colour.
void AddLight(const glm::dvec4& color, double weight, std::size_t ray, BlendedRays& seen)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    seen.Color[static_cast<std::size_t>(channel)][ray] +=
      static_cast<float>(color[channel] * color.w * weight);
  }
  seen.Passed[ray] -= static_cast<float>(color.w * weight);
}

/// Shows the extremes that rays have met.
class ExtremeLook : public BlendTracer
{
public:
  void Begin(BlendedRays& seen) const override
  {
    seen.Clear();
    seen.Value.fill(Nothing);
    for (auto& values : seen.OtherValues)
    {
      values.fill(Nothing);
    }
  }

  void Finish(const RayBatch& rays, const WorldDirections&, BlendedRays& seen) const override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (!std::isnan(seen.Value[ray]) && !this->Looks.AreIndependent())
      {
        this->Show(rays, ray, seen);
      }
      for (std::size_t part = 0; this->Looks.AreIndependent() && part < this->Looks.Parts(); ++part)
      {
        const double value = ValueOf(seen, part)[ray];
        if (!std::isnan(value))
        {
          const glm::dvec4 color = LookUp(this->Looks.Of(part).Transfer, value);
          AddLight(color, this->Looks.WeightOf(part), ray, seen);
        }
      }
    }
  }

protected:
  ExtremeLook(const BlendScene& scene, const GridCoordinates* grid)
    : Volume(scene.Key.Volume)
    , Looks(Volume)
  {
    if (!this->Looks.AreIndependent())
    {
      this->Probes.emplace_back(scene.Key.Samples, grid);
      for (const Field& other : this->Volume.Others)
      {
        this->Probes.emplace_back(other, grid);
      }
    }
  }

  static BlendedRays::Array<double>& ValueOf(BlendedRays& seen, std::size_t part)
  {
    return part == 0 ? seen.Value : seen.OtherValues[part - 1];
  }

  bool IsMinimum() const { return this->Volume.Mode == BlendMode::Minimum; }

  const Blending& Volume;
  ComponentLooks Looks;

private:
  /// Show components that depend on each other, where the one that gives the opacity has its
  /// extreme.
  void Show(const RayBatch& rays, std::size_t ray, BlendedRays& seen) const
  {
    ComponentValues values{};
    for (std::size_t c = 0; c + 1 < this->Probes.size(); ++c)
    {
      values[c] = this->Probes[c].At(rays, ray, seen.First[ray]);
    }
    values[this->Probes.size() - 1] = seen.Value[ray];
    AddLight(this->Looks.ColorOf(0, values), 1.0, ray, seen);
  }

  std::vector<FieldProbe> Probes; ///< of all components, if they depend on each other
};

/// Finds extremes exactly.
class ExtremeTracer final : public ExtremeLook
{
public:
  ExtremeTracer(const BlendScene& scene, const GridCoordinates* grid, ExtremeSearchMaker make)
    : ExtremeLook(scene, grid)
  {
    for (std::size_t part = 0; part < this->Looks.Parts(); ++part)
    {
      const std::size_t component = this->Looks.OpacityOf(part);
      const bool isFirst = component == 0;
      this->Searches.push_back(
        make({ isFirst ? scene.Key.Samples : this->Volume.Others[component - 1],
          isFirst ? scene.Ranges : nullptr, grid, this->IsMinimum() }));
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
