// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/HitOpacities.h"

#include "Scene/ValueTable.h"

#include <cstddef>

namespace TemporalCoherence
{

void FindHitOpacities(const Surfaces& surfaces, const HitList& hits,
  const std::array<RayBatch::Array<double>, 3>& gradients, RayBatch::Array<float>& opacities)
{
  const GradientOpacity& byGradient = surfaces.ByGradient;
  const ValueOpacities* const byValue = surfaces.ByArray ? surfaces.ByArray->Looks.get() : nullptr;
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    double opacity = surfaces.Opacities.empty()
      ? 1.0
      : surfaces.Opacities[static_cast<std::size_t>(hits.Surface[i])];
    if (!byGradient.Nodes.empty())
    {
      const glm::dvec3 gradient(gradients[0][i], gradients[1][i], gradients[2][i]);
      opacity *= byGradient.At(glm::length(gradient * byGradient.PerStep));
    }
    if (byValue)
    {
      opacity *= static_cast<double>(byValue->At(hits.Values[i]));
    }
    opacities[i] = static_cast<float>(opacity);
  }
}

}
