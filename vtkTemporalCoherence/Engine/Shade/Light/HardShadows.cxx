// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Light/HardShadows.h"

#include <cstddef>
#include <limits>

namespace TemporalCoherence
{

std::int64_t FindHardShadows(const LightTracer& tracer, const Appearance& appearance,
  std::size_t number, const HitList& hits, KeptShadows* kept, RayBatch::Array<float>& arriving)
{
  const Light& light = appearance.Lights[number];
  LightRayBatches batches(tracer,
    [&](std::size_t hit, float passed)
    {
      arriving[hit] = passed;
      if (kept)
      {
        kept->Keep(hits.Pixel[hit], number, passed > 0.0f);
      }
    });
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    arriving[i] = 1.0f;
    if ((hits.Misses >> i & 1u) != 0)
    {
      continue;
    }
    if (kept && kept->Knows(hits.Pixel[i], number))
    {
      arriving[i] = kept->IsLit(hits.Pixel[i], number) ? 1.0f : 0.0f;
      continue;
    }
    const glm::dvec3 point = hits.Rays.PointAt(i);
    const glm::dvec3 way = light.Positional ? light.Position - point : -light.Direction;
    const double length = glm::length(way);
    const auto& normal = hits.Normal[i];
    // A surface that turns away from the light is dark anyway.
    const bool isAway =
      appearance.TwoSided && glm::dot(glm::dvec3(normal[0], normal[1], normal[2]), way) <= 0.0;
    if (!isAway && length > 0.0)
    {
      batches.Append(point, way / length,
        light.Positional ? length : std::numeric_limits<double>::infinity(), i);
    }
  }
  const std::int64_t cells = batches.Finish();
  FillLastVector(hits.Rays.Count, arriving);
  return cells;
}

}
