// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/ProjectionTracer.h"

#include "Blending/ExtremeSearch.h"
#include "Blending/FieldProbe.h"
#include "Blending/TransferLookup.h"

#include <algorithm>
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

class ExtremeTracer final : public BlendTracer
{
public:
  ExtremeTracer(const BlendScene& scene, const GridCoordinates* grid, ExtremeSearchMaker make)
    : Volume(scene.Key.Volume)
    , AreIndependent(Volume.Use == ComponentUse::Independent || Volume.Others.empty())
  {
    const bool isMinimum = this->Volume.Mode == BlendMode::Minimum;
    if (this->AreIndependent)
    {
      this->Searches.push_back(make({ scene.Key.Samples, scene.Ranges, grid, isMinimum }));
      for (const Field& other : this->Volume.Others)
      {
        this->Searches.push_back(make({ other, nullptr, grid, isMinimum }));
      }
      return;
    }
    this->Searches.push_back(make({ this->Volume.Others.back(), nullptr, grid, isMinimum }));
    this->Probes.emplace_back(scene.Key.Samples, grid);
    for (std::size_t i = 0; i + 1 < this->Volume.Others.size(); ++i)
    {
      this->Probes.emplace_back(this->Volume.Others[i], grid);
    }
  }

  void Begin(BlendedRays& seen) const override
  {
    seen.Clear();
    seen.Value.fill(Nothing);
    for (auto& values : seen.OtherValues)
    {
      values.fill(Nothing);
    }
  }

  void Trace(const RayBatch& rays, const WorldDirections&, BlendedRays& seen) const override
  {
    this->Searches.front()->Search(rays, { seen.Value, seen.First, seen.CellsRead });
    for (std::size_t i = 1; i < this->Searches.size(); ++i)
    {
      RayBatch::Array<double> first;
      first.fill(Infinity);
      this->Searches[i]->Search(rays, { seen.OtherValues[i - 1], first, seen.CellsRead });
    }
  }

  void Finish(const RayBatch& rays, const WorldDirections&, BlendedRays& seen) const override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (!this->AreIndependent)
      {
        this->ShowDependent(rays, ray, seen);
        continue;
      }
      for (std::size_t i = 0; i < this->Searches.size(); ++i)
      {
        const double value = i == 0 ? seen.Value[ray] : seen.OtherValues[i - 1][ray];
        const ComponentLook& look = this->Volume.Looks[i];
        const double weight = this->Searches.size() == 1 ? 1.0 : look.Weight;
        if (!std::isnan(value))
        {
          AddLight(LookUp(look.Transfer, value), weight, ray, seen);
        }
      }
    }
  }

private:
  void ShowDependent(const RayBatch& rays, std::size_t ray, BlendedRays& seen) const
  {
    if (std::isnan(seen.Value[ray]))
    {
      return;
    }
    const TransferFunction& transfer = this->Volume.Looks.front().Transfer;
    glm::dvec4 color = LookUp(transfer, seen.Value[ray]);
    if (this->Volume.Use == ComponentUse::ColorOpacity)
    {
      const double value = this->Probes.front().At(rays, ray, seen.First[ray]);
      color = glm::dvec4(glm::dvec3(LookUp(transfer, value)), color.w);
    }
    for (std::size_t i = 0; this->Volume.Use == ComponentUse::RgbOpacity && i < 3; ++i)
    {
      const glm::dvec2& range = this->Volume.ScalarRanges[i];
      const double value = this->Probes[i].At(rays, ray, seen.First[ray]);
      color[static_cast<int>(i)] = std::clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
    }
    AddLight(color, 1.0, ray, seen);
  }

  const Blending& Volume;
  bool AreIndependent;
  std::vector<std::unique_ptr<const ExtremeSearch>> Searches; ///< one for each extreme
  std::vector<FieldProbe> Probes; ///< if components depend: those that give the colour
};

}

std::shared_ptr<const BlendTracer> MakeExtremeTracer(
  const BlendScene& scene, const GridCoordinates* grid, ExtremeSearchMaker make)
{
  return std::make_shared<ExtremeTracer>(scene, grid, make);
}

}
