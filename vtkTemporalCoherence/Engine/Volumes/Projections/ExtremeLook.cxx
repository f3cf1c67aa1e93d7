// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/ExtremeLook.h"

#include "Volumes/Samples/TransferLookup.h"

#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Nothing = std::numeric_limits<double>::quiet_NaN();

/// Add the light of a component to a ray.
void AddLight(const glm::dvec4& color, double weight, std::size_t ray, BlendedRays& seen)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    seen.Color[static_cast<std::size_t>(channel)][ray] +=
      static_cast<float>(color[channel] * color.w * weight);
  }
  seen.Passed[ray] -= static_cast<float>(color.w * weight);
}

}

ExtremeLook::ExtremeLook(const BlendScene& scene, const GridCoordinates* grid)
  : Volume(scene.Key.Blended())
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

void ExtremeLook::Begin(BlendedRays& seen) const
{
  seen.Clear();
  seen.Value.fill(Nothing);
  for (auto& values : seen.OtherValues)
  {
    values.fill(Nothing);
  }
}

void ExtremeLook::Finish(const RayBatch& rays, const WorldDirections&, BlendedRays& seen) const
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

/// Show dependent components at the extreme of the component that gives the opacity.
void ExtremeLook::Show(const RayBatch& rays, std::size_t ray, BlendedRays& seen) const
{
  ComponentValues values{};
  for (std::size_t c = 0; c + 1 < this->Probes.size(); ++c)
  {
    values[c] = this->Probes[c].At(rays, ray, seen.First[ray]);
  }
  values[this->Probes.size() - 1] = seen.Value[ray];
  AddLight(this->Looks.ColorOf(0, values), 1.0, ray, seen);
}

}
