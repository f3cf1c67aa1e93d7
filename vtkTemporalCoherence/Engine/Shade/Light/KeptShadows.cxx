// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Light/KeptShadows.h"

#include <algorithm>

namespace TemporalCoherence
{

bool KeptShadows::Begin(const FrameKey& key, bool areHitsOfLast)
{
  const std::vector<Light>& lights = key.Appearance.Lights;
  const bool areAny = key.Appearance.Shade &&
    std::any_of(
      lights.begin(), lights.end(), [](const Light& light) { return light.CastsHardShadows(); });
  if (!areAny || key.Isosurfaces().IsTranslucent())
  {
    *this = {};
    return false;
  }
  const auto castAlike = [](const Light& a, const Light& b)
  {
    return a.CastsHardShadows() == b.CastsHardShadows() &&
      (!a.CastsHardShadows() || ShineAlike(a, b));
  };
  const std::size_t pixels =
    static_cast<std::size_t>(key.View.Size.x) * static_cast<std::size_t>(key.View.Size.y);
  const bool isKept = areHitsOfLast && this->IsWhole && this->Bits.size() == pixels &&
    std::equal(this->Lights.begin(), this->Lights.end(), lights.begin(), lights.end(), castAlike);
  this->IsWhole = false;
  if (!isKept)
  {
    this->Bits.assign(pixels, 0);
  }
  this->Lights = lights;
  return true;
}

}
