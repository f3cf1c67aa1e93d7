// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/HitColors.h"

#include "Scene/ValueTable.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{
namespace
{

using Colors = std::array<RayBatch::Array<float>, 3>;

void FindByArray(const ArrayColors& array, const HitList& hits, Colors& colors)
{
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    const glm::vec3 color = array.Looks->At(hits.Values[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      colors[a][i] = color[static_cast<int>(a)];
    }
  }
}

void FindBySurface(const std::vector<glm::dvec3>& ofSurfaces, const HitList& hits, Colors& colors)
{
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    const glm::dvec3& color = ofSurfaces[static_cast<std::size_t>(hits.Surface[i])];
    for (std::size_t a = 0; a < 3; ++a)
    {
      colors[a][i] = static_cast<float>(color[static_cast<int>(a)]);
    }
  }
}

}

void FindHitColors(const Appearance& appearance, const HitList& hits, Colors& colors)
{
  if (!appearance.ByArray && appearance.Colors.size() == 1)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      std::fill_n(colors[a].begin(), WholeVectors(hits.Rays.Count),
        static_cast<float>(appearance.Colors[0][static_cast<int>(a)]));
    }
    return;
  }
  if (appearance.ByArray)
  {
    FindByArray(*appearance.ByArray, hits, colors);
  }
  else
  {
    FindBySurface(appearance.Colors, hits, colors);
  }
  for (RayBatch::Array<float>& channel : colors)
  {
    FillLastVector(hits.Rays.Count, channel);
  }
}

}
