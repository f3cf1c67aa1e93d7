// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HitOrder_h
#define TemporalCoherence_HitOrder_h

#include "Scene/Frame.h"
#include "Scene/RayBatch.h"

#include <cstddef>
#include <tuple>
#include <vector>

namespace TemporalCoherence
{

/// A surface on a ray, by the properties that decide its order.
struct MetSurface
{
  double Distance;
  HitKind Kind;
  double Isovalue;
};

/// True if a ray meets surface `a` before `b`, whatever their order in the list of isovalues.
///
/// Where the field jumps, as with nearest interpolation, it passes several isovalues at one
/// distance: upwards the lowest comes first, downwards the highest. A cap comes before both; of
/// several caps, the highest isovalue comes first.
inline bool IsInFront(const MetSurface& a, const MetSurface& b)
{
  const auto placeOf = [](const MetSurface& surface)
  {
    const int rank = surface.Kind == HitKind::Cap ? 0 : surface.Kind == HitKind::Entry ? 1 : 2;
    return std::tuple(surface.Distance, rank, rank == 1 ? surface.Isovalue : -surface.Isovalue);
  };
  return placeOf(a) < placeOf(b);
}

/// True if a ray of a batch meets a surface before its hit, or has no hit.
inline bool IsInFrontOfHit(const MetSurface& met, const HitBatch& hits, std::size_t ray,
  const std::vector<double>& isovalues)
{
  const SurfaceIndex hit = hits.Surface[ray];
  return hit == Frame::NoSurface ||
    IsInFront(met, { hits.Depth[ray], hits.Kind[ray], isovalues[static_cast<std::size_t>(hit)] });
}

}

#endif
