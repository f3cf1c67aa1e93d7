// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/HitColors.h"

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

using Colors = std::array<RayBatch::Array<float>, 3>;

void FindByArray(const ArrayColors& array, const HitList& hits, Colors& colors)
{
  RayBatch::Array<double> values;
  array.Values->Find(hits.Rays, hits.Cell, values);
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    const glm::vec3 color = array.Colors->At(values[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      colors[a][i] = color[static_cast<int>(a)];
    }
  }
}

}

void FindHitColors(const Appearance& appearance, const HitList& hits, Colors& colors)
{
  if (appearance.ByArray)
  {
    FindByArray(*appearance.ByArray, hits, colors);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<int>(a);
    if (!appearance.ByArray && appearance.Colors.size() == 1)
    {
      std::fill_n(colors[a].begin(), WholeVectors(hits.Rays.Count),
        static_cast<float>(appearance.Colors[0][axis]));
      continue;
    }
    for (std::size_t i = 0; !appearance.ByArray && i < hits.Rays.Count; ++i)
    {
      const glm::dvec3& color = appearance.Colors[static_cast<std::size_t>(hits.Surface[i])];
      colors[a][i] = static_cast<float>(color[axis]);
    }
    FillLastVector(hits.Rays.Count, colors[a]);
  }
}

}
