// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/HitValues.h"

namespace TemporalCoherence
{

void FindHitValues(const FrameKey& key, HitList& hits)
{
  const auto& colors = key.Appearance.ByArray;
  const auto& opacities = key.Isosurfaces().ByArray; // the same array
  if (hits.Rays.Count > 0 && (colors || opacities))
  {
    const ArrayValues& array = colors ? *colors->Values : *opacities->Values;
    array.Find(hits.Rays, hits.Cell, hits.Values);
  }
}

}
