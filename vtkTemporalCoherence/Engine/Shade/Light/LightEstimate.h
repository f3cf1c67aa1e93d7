// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LightEstimate_h
#define TemporalCoherence_LightEstimate_h

#include "Scene/RayBatch.h"
#include "Shade/Light/LightCache.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace TemporalCoherence
{

/// Sums of light that a tile found in this frame, for patches larger than those of its hits.
class TileSums
{
public:
  LightSum& At(const PatchPlace& place)
  {
    std::size_t at = (HashOfBlock(place) >> 7) + 37u * place.Patch;
    for (;; ++at)
    {
      at %= Capacity;
      if (!this->AreSet[at])
      {
        this->AreSet[at] = true;
        this->Places[at] = place;
        this->Sums[at] = {};
      }
      if (this->Places[at].Patch == place.Patch && AreTogether(this->Places[at], place))
      {
        return this->Sums[at];
      }
    }
  }

private:
  /// Room for the patches of two sizes around 64 hits, half filled.
  static constexpr std::size_t Capacity = 4 * RayBatch::Capacity;

  std::array<bool, Capacity> AreSet{};
  std::array<PatchPlace, Capacity> Places;
  std::array<LightSum, Capacity> Sums;
};

/// The light around a patch, estimated from the rays that are known.
struct Estimate
{
  void AddAll(const LightSum& sum)
  {
    this->Rays += sum.Rays();
    this->Light += sum.Light();
  }
  void AddMissing(const LightSum& sum)
  {
    if (this->Rays < LightCache::FewRays && sum.Rays() > 0)
    {
      const double rays = std::min<double>(LightCache::FewRays - this->Rays, sum.Rays());
      this->Light += sum.Light() * rays / sum.Rays();
      this->Rays += rays;
    }
  }
  double Share() const
  {
    return this->Rays > 0.0 ? this->Light / (this->Rays * LightSum::Whole) : 1.0;
  }

  double Rays = 0.0, Light = 0.0;
};

}

#endif
