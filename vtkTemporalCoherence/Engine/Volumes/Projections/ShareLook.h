// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ShareLook_h
#define TemporalCoherence_ShareLook_h

#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Samples/ComponentLooks.h"

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{

/// Shows the averages or the sums along rays as an opaque grey.
class ShareLook : public BlendTracer
{
public:
  void Finish(const RayBatch& rays, const WorldDirections&, BlendedRays& seen) const override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      double grey = 0.0;
      bool isSeen = false;
      for (std::size_t part = 0; part < this->Looks.Parts(); ++part)
      {
        const double passed = LengthOf(seen, part)[ray];
        const double length = this->IsAverage ? passed : this->Looks.Of(part).UnitDistance;
        isSeen = isSeen || passed > 0.0;
        grey += length > 0.0 ? this->Looks.WeightOf(part) * SumOf(seen, part)[ray] / length : 0.0;
      }
      if (isSeen)
      {
        for (auto& channel : seen.Color)
        {
          channel[ray] = static_cast<float>(std::clamp(grey, 0.0, 1.0));
        }
        seen.Passed[ray] = 0.0f;
      }
    }
  }

protected:
  using Array = BlendedRays::Array<double>;

  explicit ShareLook(const Blending& volume)
    : IsAverage(volume.Mode == BlendMode::Average)
    , Looks(volume)
  {
  }

  static Array& SumOf(BlendedRays& seen, std::size_t part)
  {
    return part == 0 ? seen.Value : seen.OtherValues[part - 1];
  }
  static Array& LengthOf(BlendedRays& seen, std::size_t part)
  {
    return part == 0 ? seen.Length : seen.OtherLengths[part - 1];
  }

  /// Count all of a ray in a sum: VTK shows a sum of nothing as black.
  void BeginSum(const RayBatch& rays, std::size_t ray, BlendedRays& seen) const
  {
    if (!this->IsAverage && rays.Begin[ray] < rays.End[ray])
    {
      seen.Length[ray] += rays.End[ray] - rays.Begin[ray];
      seen.First[ray] = std::min(seen.First[ray], rays.Begin[ray]);
    }
  }

  bool IsAverage;
  ComponentLooks Looks;
};

}

#endif
